// SPDX-License-Identifier: MIT
// The measures of the drawn lines beside the window. In: pictures and their frame, once a frame. Out: the
// newest measures, the pinned state's, and overlays that show lines on pictures. The thread that measures
// gets plain copies; the window never waits for it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/window/cause_desk.h"
#include "app/window/full_mesh_desk.h"
#include "app/window/pictures.h"
#include "app/window/tile.h"
#include "app/workbench/live_judge.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

class JudgeDesk {
 public:
  /// `news` must outlive it.
  explicit JudgeDesk(News& news) : causes(news), full_mesh_(news), judge_(news), pinned_judge_(news) {}

  /// What is looked at: nothing is read or measured that nobody sees.
  struct Wanted {
    bool measures = false, lines = false, causes = false;
  };

  /// Takes in what was measured and asks for what is not up to date. `hurry`: something is being dragged, so
  /// that the full mesh's lines wait. Errors (input, work): as `Pictures::refresh`.
  void refresh(Pictures& pictures, const Frame& frame, Wanted wanted, bool hurry);

  /// The newest measures, perhaps of settings a moment ago; null before the first ones.
  const Judgement* now() const { return now_ ? &*now_ : nullptr; }
  /// The pinned state's; null where none is pinned or it is not measured yet.
  const Judgement* pinned() const { return pinned_ ? &*pinned_ : nullptr; }
  /// Whether `now` is of other settings than the last ones seen.
  bool is_behind() const { return behind_; }

  /// The lines to lay over pictures of the present settings; none where there are none yet.
  TileOverlay overlay(Overlay kind, ReferenceDesk& reference);

  /// Reloads changed shaders of the passes that its parts have of their own. Errors and result: as of
  /// `Pipeline`.
  bool reload_changed_shaders();
  /// As `Pipeline::shader_problem`.
  std::string shader_problem();

  CauseDesk causes;

 private:
  void refresh_measures(const Frame& frame, const FoundLines& lines, const KeyedView& full);
  void refresh_pinned(const Pictures& pictures);
  void take_results();

  uint64_t last_id_ = 0;
  bool behind_ = false;
  std::optional<Judgement> now_, pinned_;
  FullMeshDesk full_mesh_;
  Stage<Texture> matches_;
  LiveJudge judge_, pinned_judge_;
};

}  // namespace inkbench
