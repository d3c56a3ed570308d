// SPDX-License-Identifier: MIT
// Why lines are false or missing, beside the window. In: pictures' frame, once a frame. Out: the causes of
// the newest frame, and an overlay of them. It draws with passes of its own, a step a frame, so that the
// window's are not run again and no frame waits for all of them.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/window/tile.h"
#include "app/workbench/live_reference.h"
#include "pipeline/pipeline.h"
#include "studies/judging/cause_finder.h"

namespace inkbench {

class CauseDesk {
 public:
  /// `news` must outlive it.
  explicit CauseDesk(News& news) : news_(news) {}

  /// Does a step towards the causes of the frame; none while something is dragged (`hurry`). What goes wrong
  /// is told by `error`.
  void refresh(Pipeline& pipeline, const Frame& frame, bool hurry);
  /// Reloads changed shaders of its own passes, if it has any. Errors and result: as of `Pipeline`.
  bool reload_changed_shaders() { return own_ && own_->pipeline.reload_changed_shaders(); }
  /// As `Pipeline::shader_problem`.
  std::string shader_problem() { return own_ ? own_->pipeline.shader_problem() : ""; }
  /// What failed is tried again with the next frame.
  void try_again() {
    if (!error_.empty()) asked_.reset();
  }
  /// Frees what nobody looks at; to be called again while lines are being found.
  void forget();

  /// Whether another frame would bring the causes on.
  bool has_step() const { return has_step_; }
  /// Of the last frame seen; null while they are being found and where that failed.
  const CauseMaps* now() const { return !is_behind_ && found_ ? &found_->maps : nullptr; }
  /// Of `now`, which must be there.
  const CauseCounts& counts() const { return found_->counts; }
  double tolerance_px() const { return found_->tolerance_px; }
  /// Why there are none for the last frame seen; "" as a rule.
  const std::string& error() const { return error_; }
  /// Of the newest causes, perhaps of a frame a moment ago; none before the first ones.
  TileOverlay overlay();

 private:
  struct Own {
    Own(const std::shared_ptr<LineFinder>& finder, News& news) : pipeline(finder), lines(finder, news) {}
    Pipeline pipeline;
    LiveReference lines;
    std::optional<FoundLines> found_lines;
    std::optional<CauseFinder> causes;
  };
  struct Found {
    CauseMaps maps;
    CauseCounts counts;
    double tolerance_px = 0;
    Key key;
  };
  std::shared_ptr<const ReferenceLines> lines_of(const LineRequest& request);
  void do_step(Pipeline& pipeline, const Frame& frame, const Key& key);

  News& news_;
  std::unique_ptr<Own> own_;
  std::optional<Key> asked_;  ///< What `own_->causes` is finding, or what failed.
  std::optional<Found> found_;
  std::string error_;
  bool is_behind_ = false, has_step_ = false;
  Stage<Texture> overlay_;
};

}  // namespace inkbench
