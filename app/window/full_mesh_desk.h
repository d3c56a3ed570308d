// What the full mesh gives under the same settings, for judging a level of it. In: the settings, once a
// frame. Out: the full mesh's edges and reference lines. They come from passes of their own, so that the
// window's are not run again.
#pragma once

#include <memory>

#include "app/window/reference_desk.h"
#include "app/workbench/live_judge.h"
#include "pipeline/pipeline.h"

namespace inkbench {

/// What a level is judged against; `view` is empty where there is nothing (yet).
struct FullView {
  JudgedView view;
  Key key;
};

class FullMeshDesk {
 public:
  /// The view of the frame's scene with the full mesh; none where the settings draw the full mesh, and none
  /// of another camera or scene while something is dragged (`hurry`). Errors (input, work): as
  /// `Pictures::refresh`.
  FullView refresh(Pipeline& pipeline, const Frame& frame, bool hurry);
  /// Frees what nobody looks at; to be called again while lines are being found.
  void forget();

  /// Whether `refresh` gave nothing because it is still being made.
  bool is_behind() const { return behind_; }
  /// Whether there are new lines since the last call.
  bool take_news() { return own_ && own_->reference.take_news(); }

 private:
  struct Own {
    explicit Own(const std::shared_ptr<LineFinder>& finder) : pipeline(finder) {}
    Pipeline pipeline;
    ReferenceDesk reference{pipeline};
  };
  bool refresh_lines(MeshStore& meshes, const Frame& full, bool hurry);

  std::unique_ptr<Own> own_;
  Stage<std::shared_ptr<const Image>> edges_;
  bool behind_ = false;
};

}  // namespace inkbench
