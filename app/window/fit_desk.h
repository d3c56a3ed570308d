// SPDX-License-Identifier: MIT
// Fitting parameters to the reference lines, beside the window: what may move, the search that runs, what it
// found and for how long that says something. Panels read it and call it.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/workbench/document.h"
#include "app/workbench/fit_run.h"
#include "app/workbench/fit_spec.h"
#include "app/workbench/session.h"
#include "pipeline/base/scratch_folder.h"

namespace inkbench {

class FitDesk {
 public:
  FitOptions options;

  // --- what may move ---

  /// The method's parameters, then others that were ticked.
  std::vector<std::string> offered(const Settings& settings) const;
  bool is_ticked(const Settings& settings, const std::string& key) const;
  void tick(const std::string& key, bool on) { ticks_[key] = on; }
  std::vector<std::string> ticked(const Settings& settings) const;

  // --- the search ---

  /// With marks where the options want them and there are some of the image's size. Begins, and drops what
  /// was found before. Errors (input): nothing is ticked; (work): it cannot be started.
  void start(const Settings& settings, std::span<const CameraBookmark> kept, const PaintedMarks& marks);
  void cancel();
  /// Once a frame: takes in what the search tells. Returns whether anything changed.
  bool follow(const Document& document);
  bool is_running() const { return run_ && !run_->is_over(); }
  /// The last search, while it runs and until `clear`; null without one.
  const FitRun* run() const { return run_.get(); }
  const FitRequest& request() const { return request_; }
  /// Forgets what was found.
  void clear();

  // --- what it found ---

  /// Once the search is over; null before, and where it found nothing.
  const FitResult* result() const;
  /// Whether it is about the document's settings: these may have moved on.
  bool holds() const { return holds_; }
  /// Whether the settings have all of its values already.
  bool is_set() const { return is_set_; }
  /// The settings with its values, as one step of the history. Errors (input): a parameter that is gone.
  void take_over(Document& document) const;
  /// How good the parameter's values are, while the result holds; null where that is not known.
  const ValueHeat* heat(const std::string& key) const;

 private:
  std::map<std::string, bool> ticks_;  ///< Those that a person set, by key.
  FitRequest request_;                 ///< Of the last search.
  std::unique_ptr<ScratchFolder> folder_;
  std::unique_ptr<FitRun> run_;  ///< Ends before its folder goes.
  long seen_revision_ = -1;      ///< Of the document, for which the next two are.
  bool holds_ = false, is_set_ = false;
};

}  // namespace inkbench
