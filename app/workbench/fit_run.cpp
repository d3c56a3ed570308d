// SPDX-License-Identifier: MIT
#include "app/workbench/fit_run.h"

#include <csignal>
#include <cstring>
#include <nlohmann/json.hpp>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

constexpr std::string_view kFitErrorStart = "inkbench: error: ";

size_t count_in(const nlohmann::json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_number_unsigned() ? found->get<size_t>() : 0;
}

}  // namespace

std::optional<FitProgress> parse_fit_progress(const std::string& line) {
  if (!line.starts_with('{')) return std::nullopt;
  const auto json = nlohmann::ordered_json::parse(line, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  FitProgress progress{count_in(json, "done"), count_in(json, "total"), {}, {}};
  if (progress.done == 0) return std::nullopt;
  const auto best = json.find("best");
  if (best != json.end() && best->is_number()) progress.best = best->get<double>();
  const auto values = json.find("values");
  if (values == json.end() || !values->is_object()) return progress;
  for (const auto& [key, value] : values->items()) {
    if (value.is_string()) progress.values.emplace_back(key, value.get<std::string>());
  }
  return progress;
}

FitRun::FitRun(const std::filesystem::path& program, const std::filesystem::path& spec,
               const std::filesystem::path& folder)
    : folder_(folder),
      process_(std::make_unique<ChildProcess>(
          std::vector<std::string>{program.string(), "tune", spec.string(), "--out", folder.string(),
                                   "--no-report", "--progress", "json"},
          ChildOptions{.yields = true})) {}

bool FitRun::listen() {
  const ChildProcess::Lines lines = process_->take_lines();
  for (const std::string& line : lines.out) {
    std::optional<FitProgress> progress = parse_fit_progress(line);
    if (!progress) continue;
    progress_ = std::move(*progress);
    if (progress_.best) trace_.push_back({progress_.done, *progress_.best});
  }
  for (const std::string& line : lines.err) {
    // That it was stopped is what was asked for.
    if (line.starts_with(kFitErrorStart) && state_ != FitState::stopping)
      problem_ = line.substr(kFitErrorStart.size());
  }
  return !lines.out.empty() || !lines.err.empty();
}

FitResult FitRun::best_so_far() const {
  FitResult result;
  result.stopped = true;
  result.candidates = progress_.done;
  if (!trace_.empty()) result.before = trace_.front().best;
  result.after = progress_.best;
  for (const auto& [key, value] : progress_.values) result.parameters.push_back({key, value, true, {}});
  return result;
}

/// One that was stopped by force leaves no files; what it told is known.
void FitRun::read_result() {
  try {
    result_ = read_fit_result(folder_);
  } catch (const Error& error) {
    if (state_ == FitState::stopped && progress_.best) result_ = best_so_far();
    if (state_ != FitState::finished) return;
    state_ = FitState::failed;
    problem_ = error.what();
  }
}

void FitRun::note_end() {
  if (process_->exit_status() == 0) {
    state_ = FitState::finished;
  } else if (state_ == FitState::stopping) {
    state_ = FitState::stopped;
  } else {
    state_ = FitState::failed;
    if (process_->signal() != 0)
      problem_ = std::string("was ended by the system: ") + strsignal(process_->signal());
  }
  process_.reset();
  if (state_ != FitState::failed) read_result();
}

bool FitRun::poll() {
  if (is_over()) return false;
  const bool over = !process_->is_running();  // asked first, so that its last lines are not missed
  const bool changed = listen();
  if (over) note_end();
  return changed || over;
}

void FitRun::cancel() {
  if (is_over()) return;
  process_->send(state_ == FitState::stopping ? SIGKILL : SIGINT);
  state_ = FitState::stopping;
}

}  // namespace inkbench
