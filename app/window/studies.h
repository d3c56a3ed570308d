// SPDX-License-Identifier: MIT
// The window's studies: the one that is being made, those that run or ran, and the one whose grid is looked
// at. Panels read it and call it.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/recent_studies.h"
#include "app/workbench/study_form.h"
#include "app/workbench/study_queue.h"
#include "app/workbench/study_results.h"

namespace inkbench {

/// A study in the list.
struct ListedStudy {
  RecentStudy study;
  StudyState state = StudyState::stopped;
  size_t done = 0, total = 0;  ///< Cells; `done` of one that does not run is known once it is looked at.
  const StudyJob* job = nullptr;
};

class Studies {
 public:
  /// Reads the list of earlier studies; where that fails, why is a message.
  Studies();

  bool page_open = false;  ///< In the place of the pictures.

  // --- making one ---

  /// A new form that sweeps the parameter. Errors (input): it cannot be swept.
  void sweep(const Settings& settings, const std::string& key);
  /// The parameter as another axis of the form: rows, then pages. Errors (input): as `sweep`; three are
  /// there.
  void add_axis(const Settings& settings, const std::string& key);
  void new_form(const Settings& settings);
  /// Any spec file. Errors (input): it cannot be read.
  void open_spec(const std::filesystem::path& file);
  StudyForm* form() { return form_ ? &*form_ : nullptr; }
  const StudyForm* form() const { return form_ ? &*form_ : nullptr; }
  /// The form with these settings; checked again only when something changed and `settled`.
  const CheckedForm& checked(const Settings& settings, const std::filesystem::path& scene, bool settled);
  /// As it was last checked.
  const CheckedForm& last_checked() const { return checked_.result; }
  /// Seconds that the checked form takes, about: from studies that ran, else from what the window's own
  /// passes take. Below 0 where nothing is known.
  double estimated_seconds(double pass_seconds_per_pixel) const;
  /// Saves the spec where needed. Errors (work): it cannot be written.
  void save();
  /// Saves it and runs it; shows its grid. Errors as `save`.
  void run();

  // --- those that run or ran ---

  /// Newest first. The jobs in it live until the next `poll` or change.
  std::vector<ListedStudy> list() const;
  /// Runs it again: cells that are there stay.
  void resume(const RecentStudy& study);
  void cancel(const RecentStudy& study);
  /// Takes it off the list; its files stay.
  void forget(const RecentStudy& study);
  /// Once a frame. Returns whether anything changed.
  bool poll();
  bool is_busy() const { return queue_.is_busy(); }
  /// The job that runs now, or nullptr.
  const StudyJob* running() const;
  /// Before the window goes: ends what runs, so that it can be continued.
  void stop();
  struct Message {
    bool is_problem = false;
    std::string text;
  };
  std::vector<Message> take_messages();

  // --- the one that is looked at ---

  /// Its grid, as far as it is there. Errors (input): as `StudyResults`.
  void show(const RecentStudy& study);
  /// A folder of results. Errors as `show`.
  void open_folder(const std::filesystem::path& folder);
  void show_form() { shows_form_ = true; }
  bool shows_form() const { return shows_form_; }
  const std::optional<RecentStudy>& shown() const { return shown_; }
  /// Nothing before its first cell.
  const std::optional<StudyResults>& results() const { return results_; }
  /// Rises when pictures that were there may be others now.
  long results_revision() const { return results_revision_; }

 private:
  std::vector<RecentStudy> listed() const;
  void remember(const RecentStudy& study);
  void refresh_results(bool again);
  StudySummary summary_of(const std::filesystem::path& folder);
  void note_end(const StudyJob& job);

  struct Known {
    RecentStudy study;
    StudySummary summary;  ///< As it was when last looked at.
  };
  std::vector<Known> recent_;
  std::vector<Message> messages_;
  StudyQueue queue_;
  std::optional<StudyForm> form_;
  struct {
    std::optional<StudyForm> form;
    std::string settings;
    bool has_folder = false;
    CheckedForm result;
  } checked_;
  bool shows_form_ = true;
  std::optional<RecentStudy> shown_;
  std::optional<StudyResults> results_;
  long results_revision_ = 0;
  std::chrono::steady_clock::time_point refreshed_;
  std::optional<double> seconds_per_pixel_, seconds_per_measured_pixel_;  ///< Of studies that ran.
};

}  // namespace inkbench
