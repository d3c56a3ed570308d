// SPDX-License-Identifier: MIT
#include "app/workbench/study_queue.h"

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>
#include <utility>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

constexpr double kPatienceSeconds = 2.0;
constexpr std::string_view kErrorStart = "inkbench: error: ", kNoteStart = "inkbench: note: ";

}  // namespace

double StudyJob::seconds_left() const {
  const size_t tried = drawn + failed;
  if (tried == 0 || seconds <= 0 || total < done + failed) return -1.0;
  return seconds / static_cast<double>(tried) * static_cast<double>(total - done - failed);
}

// JSON throws where a value is of another type, which `take_line` asks first.
// NOLINTNEXTLINE(bugprone-exception-escape)
StudyQueue::~StudyQueue() {
  stop_all(kPatienceSeconds);
}

int StudyQueue::add(const std::string& title, const std::filesystem::path& spec,
                    const std::filesystem::path& folder) {
  for (const StudyJob& job : jobs_) {
    if (job.folder == folder && !job.is_over()) return job.number;
  }
  std::erase_if(jobs_, [&](const StudyJob& job) { return job.folder == folder; });
  jobs_.push_back({.number = next_number_++, .title = title, .spec = spec, .folder = folder});
  return jobs_.back().number;
}

StudyJob* StudyQueue::running() {
  const auto found = std::find_if(jobs_.begin(), jobs_.end(), [](const StudyJob& job) {
    return job.state == StudyState::running || job.state == StudyState::stopping;
  });
  return found == jobs_.end() ? nullptr : &*found;
}

bool StudyQueue::is_busy() const {
  return std::any_of(jobs_.begin(), jobs_.end(), [](const StudyJob& job) { return !job.is_over(); });
}

void StudyQueue::start(StudyJob& job) {
  try {
    process_ = std::make_unique<ChildProcess>(
        std::vector<std::string>{program_.string(), "study", job.spec.string(), "--out", job.folder.string(),
                                 "--progress", "json"},
        ChildOptions{.yields = true});
    job.state = StudyState::running;
    told_.clear();
  } catch (const Error& error) {
    job.state = StudyState::failed;
    job.problem = error.what();
    messages_.push_back({true, job.title + ": " + error.what()});
  }
}

/// A line of progress, or one for people, which is passed over.
void StudyQueue::take_line(StudyJob& job, const std::string& line) {
  if (!line.starts_with('{')) return;
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object()) return;
  const auto number = [&](const char* name) {
    const auto found = json.find(name);
    const bool good = found != json.end() && found->is_number() && found->get<double>() >= 0;
    return good ? found->get<double>() : 0.0;
  };
  job.done = static_cast<size_t>(number("done"));
  job.total = static_cast<size_t>(number("total"));
  job.drawn = static_cast<size_t>(number("drawn"));
  job.failed = static_cast<size_t>(number("failed"));
  job.seconds = number("seconds");
}

bool StudyQueue::listen(StudyJob& job) {
  const ChildProcess::Lines lines = process_->take_lines();
  for (const std::string& line : lines.out) take_line(job, line);
  for (const std::string& line : lines.err) {
    const bool is_error = line.starts_with(kErrorStart);
    if (!is_error && !line.starts_with(kNoteStart)) continue;
    const std::string text = line.substr(is_error ? kErrorStart.size() : kNoteStart.size());
    // That it was stopped is what was asked for.
    if (is_error && job.state == StudyState::stopping) continue;
    if (is_error) job.problem = text;
    if (!is_error && !told_.insert(text).second) continue;
    messages_.push_back({is_error, job.title + ": " + text});
  }
  return !lines.out.empty() || !lines.err.empty();
}

void StudyQueue::note_end(StudyJob& job) {
  const bool all_tried = job.total > 0 && job.done + job.failed == job.total;
  if (process_->exit_status() == 0 || (process_->exit_status() == 1 && all_tried)) {
    job.state = StudyState::finished;
  } else if (job.state == StudyState::stopping) {
    job.state = StudyState::stopped;
  } else {
    job.state = StudyState::failed;
    if (process_->signal() != 0) {
      job.problem = std::string("was ended by the system: ") + strsignal(process_->signal());
      messages_.push_back({true, job.title + ": " + job.problem});
    }
  }
  process_.reset();
}

bool StudyQueue::poll() {
  bool changed = false;
  if (StudyJob* job = running()) {
    const bool over = !process_->is_running();  // asked first, so that its last lines are not missed
    changed = listen(*job);
    if (!over) return changed;
    note_end(*job);
    changed = true;
  }
  const auto next = std::find_if(jobs_.begin(), jobs_.end(),
                                 [](const StudyJob& job) { return job.state == StudyState::waiting; });
  if (next == jobs_.end()) return changed;
  start(*next);
  return true;
}

void StudyQueue::cancel(int number) {
  for (StudyJob& job : jobs_) {
    if (job.number != number) continue;
    if (job.state == StudyState::waiting) job.state = StudyState::stopped;
    if (job.state == StudyState::stopping) process_->send(SIGKILL);
    if (job.state != StudyState::running) continue;
    job.state = StudyState::stopping;
    process_->send(SIGINT);
  }
}

void StudyQueue::stop_all(double patience_seconds) {
  for (StudyJob& job : jobs_) cancel(job.number);
  StudyJob* job = running();
  if (job == nullptr) return;
  if (!process_->wait_for_end(patience_seconds)) {
    process_->send(SIGKILL);
    process_->wait_for_end(patience_seconds);
  }
  listen(*job);
  note_end(*job);
}

std::vector<StudyQueue::StudyMessage> StudyQueue::take_messages() {
  return std::exchange(messages_, {});
}

}  // namespace inkbench
