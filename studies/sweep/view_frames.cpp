// SPDX-License-Identifier: MIT
#include "studies/sweep/view_frames.h"

#include <utility>

namespace inkbench {

ViewFrame ViewFrames::at(const Cell& cell, size_t view) {
  if (!spec_.camera_path) return {pipeline_.at(view_settings(spec_, cell, view)), std::nullopt};
  const bool goes_on = last_ && last_cell_ == cell.index && last_view_ <= view;
  if (!goes_on) last_ = {pipeline_.at(view_settings(spec_, cell, 0)), std::nullopt};
  for (size_t next = goes_on ? last_view_ + 1 : 1; next <= view; ++next) {
    const Frame before = last_->frame;
    last_ = {pipeline_.at(view_settings(spec_, cell, next), before), before};
  }
  last_cell_ = cell.index;
  last_view_ = view;
  return *last_;
}

}  // namespace inkbench
