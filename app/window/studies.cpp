// SPDX-License-Identifier: MIT
#include "app/window/studies.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "app/workbench/duration_text.h"
#include "app/workbench/own_program.h"
#include "app/workbench/study_plan.h"
#include "app/workbench/user_folder.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

constexpr double kPatienceSeconds = 5.0;
constexpr auto kRefreshTime = std::chrono::milliseconds(400);
/// Of reading a picture back and writing it as PNG, on one core.
constexpr double kWriteSecondsPerPixel = 1e-7;

fs::path list_file() {
  return user_folder() / "studies.toml";
}

}  // namespace

Studies::Studies() : queue_(own_program()) {
  try {
    for (const RecentStudy& study : load_recent_studies(list_file()))
      recent_.push_back({study, summary_of(study.folder)});
  } catch (const Error& error) {
    messages_.push_back({true, error.what()});
  }
}

StudySummary Studies::summary_of(const fs::path& folder) {
  try {
    return read_summary(folder);
  } catch (const Error&) {
    return {};
  }
}

/// As the disk has it, since another window may have added to it; as it was last known where there is none.
std::vector<RecentStudy> Studies::listed() const {
  std::vector<RecentStudy> studies;
  try {
    studies = load_recent_studies(list_file());
  } catch (const Error&) {
    // It was told at the start.
  }
  if (!studies.empty()) return studies;
  for (const Known& known : recent_) studies.push_back(known.study);
  return studies;
}

void Studies::remember(const RecentStudy& study) {
  std::vector<RecentStudy> studies = listed();
  add_recent_study(studies, study);
  std::vector<Known> next;
  for (const RecentStudy& one : studies) next.push_back({one, summary_of(one.folder)});
  recent_ = std::move(next);
  try {
    save_recent_studies(list_file(), studies);
  } catch (const Error& error) {
    messages_.push_back({true, error.what()});
  }
}

void Studies::forget(const RecentStudy& study) {
  std::vector<RecentStudy> studies = listed();
  std::erase_if(studies, [&](const RecentStudy& one) { return one.folder == study.folder; });
  std::erase_if(recent_, [&](const Known& known) { return known.study.folder == study.folder; });
  if (shown_ && shown_->folder == study.folder) {
    shown_.reset();
    results_.reset();
    shows_form_ = true;
  }
  save_recent_studies(list_file(), studies);
}

// --- making one ---

void Studies::new_form(const Settings& settings) {
  form_ = empty_form(settings, studies_folder());
  shows_form_ = page_open = true;
}

void Studies::sweep(const Settings& settings, const std::string& key) {
  const SweepAxis axis = suggested_axis(settings, key);
  new_form(settings);
  form_->request.axes = {axis};
}

void Studies::add_axis(const Settings& settings, const std::string& key) {
  if (!form_ || form_->own_text) return sweep(settings, key);
  std::vector<SweepAxis>& axes = form_->request.axes;
  if (axes.size() >= 3) throw input_error(key, "is a fourth axis", "take one of the three off first");
  axes.push_back(suggested_axis(settings, key));
  shows_form_ = page_open = true;
}

void Studies::open_spec(const fs::path& file) {
  form_ = form_of_file(file, studies_folder());
  shows_form_ = page_open = true;
}

const CheckedForm& Studies::checked(const Settings& settings, const fs::path& scene, bool settled) {
  const bool known = checked_.form.has_value();
  if (known && !settled) return checked_.result;
  const std::string text = settings_text(settings) + "\n" + scene.string();
  std::error_code error;
  const bool has_folder = fs::is_directory(form_->folder, error);
  const bool is_same = known && *checked_.form == *form_ && checked_.has_folder == has_folder;
  if (is_same && checked_.settings == text) return checked_.result;
  checked_.result = check_form(*form_, settings, scene);
  checked_.form = *form_;
  checked_.settings = text;
  checked_.has_folder = has_folder;
  return checked_.result;
}

double Studies::estimated_seconds(double pass_seconds_per_pixel) const {
  if (!checked_.result.spec) return -1.0;
  const StudySpec& spec = *checked_.result.spec;
  const std::optional<double>& known =
      spec.measures.empty() ? seconds_per_pixel_ : seconds_per_measured_pixel_;
  if (!known && !spec.measures.empty()) return -1.0;  // what measuring takes, the passes do not tell
  return pixel_count(spec) * known.value_or(pass_seconds_per_pixel + kWriteSecondsPerPixel);
}

void Studies::save() {
  save_form(checked_.result);
  checked_.form.reset();  // what is on the disk is another thing now
}

void Studies::run() {
  const CheckedForm form = checked_.result;
  if (!form.spec) return;
  save();
  resume({form.spec->title, fs::absolute(form.draft.path), fs::absolute(form.out)});
}

// --- those that run or ran ---

std::vector<ListedStudy> Studies::list() const {
  std::vector<ListedStudy> list;
  for (const Known& known : recent_) {
    ListedStudy entry{.study = known.study, .total = known.summary.cells};
    if (known.summary.state == "finished") {
      entry.state = StudyState::finished;
      entry.done = entry.total;
    }
    for (const StudyJob& job : queue_.jobs()) {
      if (job.folder != known.study.folder) continue;
      entry.job = &job;
      entry.state = job.state;
      entry.done = job.done;
      entry.total = std::max(job.total, entry.total);
    }
    list.push_back(std::move(entry));
  }
  return list;
}

void Studies::resume(const RecentStudy& study) {
  queue_.add(study.title, study.spec, study.folder);
  remember(study);
  shown_ = study;
  shows_form_ = false;
  page_open = true;
  refresh_results(true);
}

void Studies::cancel(const RecentStudy& study) {
  for (const StudyJob& job : queue_.jobs()) {
    if (job.folder == study.folder) return queue_.cancel(job.number);
  }
}

const StudyJob* Studies::running() const {
  for (const StudyJob& job : queue_.jobs()) {
    if (job.state == StudyState::running || job.state == StudyState::stopping) return &job;
  }
  return nullptr;
}

void Studies::note_end(const StudyJob& job) {
  if (job.state == StudyState::finished)
    messages_.push_back({false, fmt::format("{}: finished, {} cells in {}", job.title, job.done,
                                            duration_text(job.seconds))});
  if (job.state == StudyState::stopped)
    messages_.push_back(
        {false, fmt::format("{}: stopped after {} of {} cells", job.title, job.done, job.total)});
  for (Known& known : recent_) {
    if (known.study.folder == job.folder) known.summary = summary_of(job.folder);
  }
  if (shown_ && shown_->folder == job.folder) refresh_results(true);
  if (!results_ || job.drawn < 4 || !shown_ || shown_->folder != job.folder) return;
  const StudySpec& spec = results_->spec();
  const double pixels = pixel_count(spec) / static_cast<double>(cell_count(spec));
  (spec.measures.empty() ? seconds_per_pixel_ : seconds_per_measured_pixel_) =
      job.seconds / (pixels * static_cast<double>(job.drawn));
}

bool Studies::poll() {
  std::unordered_set<int> open;
  for (const StudyJob& job : queue_.jobs()) {
    if (!job.is_over()) open.insert(job.number);
  }
  if (open.empty()) return false;
  const bool changed = queue_.poll();
  for (const auto& [is_problem, text] : queue_.take_messages()) messages_.push_back({is_problem, text});
  for (const StudyJob& job : queue_.jobs()) {
    if (job.is_over() && open.contains(job.number)) note_end(job);
  }
  if (changed && std::chrono::steady_clock::now() - refreshed_ > kRefreshTime) refresh_results(false);
  return changed;
}

void Studies::stop() {
  queue_.stop_all(kPatienceSeconds);
}

std::vector<Studies::Message> Studies::take_messages() {
  return std::exchange(messages_, {});
}

// --- the one that is looked at ---

/// `again`: as a whole, since its spec may be another one; else what was added.
void Studies::refresh_results(bool again) {
  refreshed_ = std::chrono::steady_clock::now();
  if (!shown_) return;
  if (results_ && !again) {
    results_->refresh();
    if (!results_->is_replaced()) return;
  }
  try {
    results_ = StudyResults(shown_->folder, shown_->spec);
  } catch (const Error&) {  // before its first cell
    results_.reset();
  }
  ++results_revision_;
}

void Studies::show(const RecentStudy& study) {
  shown_ = study;
  shows_form_ = false;
  page_open = true;
  results_.reset();
  ++results_revision_;
  const bool may_be_empty = std::any_of(queue_.jobs().begin(), queue_.jobs().end(), [&](const StudyJob& job) {
    return job.folder == study.folder && !job.is_over();
  });
  if (may_be_empty) return refresh_results(true);
  results_ = StudyResults(study.folder, study.spec);
}

void Studies::open_folder(const fs::path& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  const StudySummary summary = read_summary(path);
  const RecentStudy study{summary.title, "", path};
  show(study);
}

}  // namespace inkbench
