// SPDX-License-Identifier: MIT
#include "app/window/fit_desk.h"

#include <algorithm>

#include "app/workbench/own_program.h"
#include "app/workbench/param_changes.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"

namespace inkbench {

std::vector<std::string> FitDesk::offered(const Settings& settings) const {
  std::vector<std::string> keys = usual_fit_keys(settings);
  for (const auto& [key, on] : ticks_) {
    const bool is_more = std::find(keys.begin(), keys.end(), key) == keys.end();
    if (on && is_more && can_fit(settings, key)) keys.push_back(key);
  }
  return keys;
}

bool FitDesk::is_ticked(const Settings& settings, const std::string& key) const {
  const auto set = ticks_.find(key);
  return set != ticks_.end() ? set->second : is_fitted_at_first(settings, key);
}

std::vector<std::string> FitDesk::ticked(const Settings& settings) const {
  std::vector<std::string> keys = offered(settings);
  std::erase_if(keys, [&](const std::string& key) { return !is_ticked(settings, key); });
  return keys;
}

void FitDesk::start(const Settings& settings, std::span<const CameraBookmark> kept,
                    const PaintedMarks& marks) {
  FitRequest request{settings,
                     ticked(settings),
                     {},
                     options.budget,
                     fit_marks(settings, marks, options),
                     options.uses_reference};
  std::vector<CameraParams> cameras;
  for (const CameraBookmark& bookmark : kept) cameras.push_back(bookmark.camera);
  request.cameras = fit_cameras(settings, cameras, request.marks, options);
  const std::string spec = fit_spec_text(request, "scene.toml");
  clear();
  folder_ = std::make_unique<ScratchFolder>();
  write_file_atomically(folder_->path() / "scene.toml", fit_scene_text(request));
  write_file_atomically(folder_->path() / "fit.toml", spec + write_fit_marks(folder_->path(), request));
  request_ = std::move(request);
  run_ = std::make_unique<FitRun>(own_program(), folder_->path() / "fit.toml", folder_->path() / "found");
}

void FitDesk::cancel() {
  if (run_) run_->cancel();
}

bool FitDesk::follow(const Document& document) {
  if (!run_) return false;
  const bool changed = run_->poll();
  if (seen_revision_ == document.revision() && !changed) return false;
  seen_revision_ = document.revision();
  holds_ = is_still_about(request_, document.settings());
  is_set_ = holds_ && run_->result() &&
            same_settings(with_fit(document.settings(), *run_->result()), document.settings());
  return changed;
}

void FitDesk::clear() {
  run_.reset();
  folder_.reset();
  holds_ = is_set_ = false;
  seen_revision_ = -1;
}

const FitResult* FitDesk::result() const {
  return run_ && run_->result() ? &*run_->result() : nullptr;
}

void FitDesk::take_over(Document& document) const {
  const FitResult* found = result();
  if (found == nullptr) return;
  const Settings next = with_fit(document.settings(), *found);
  document.replace(next, "fit " + changes_name(changed_params(document.settings(), next)));
}

const ValueHeat* FitDesk::heat(const std::string& key) const {
  const FitResult* found = result();
  if (found == nullptr || !holds_) return nullptr;
  for (const FittedParameter& fitted : found->parameters) {
    if (fitted.key == key && fitted.heat) return &*fitted.heat;
  }
  return nullptr;
}

}  // namespace inkbench
