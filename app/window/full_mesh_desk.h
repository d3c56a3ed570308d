// SPDX-License-Identifier: MIT
// What the full mesh gives under the same settings, for judging a level of it. In: the settings, once a
// frame. Out: the full mesh's edges and reference lines. They come from passes of their own, so that the
// window's are not run again.
#pragma once

#include <memory>

#include "app/window/reference_desk.h"
#include "pipeline/pipeline.h"

namespace inkbench {

class FullMeshDesk {
 public:
  /// `news` must outlive it.
  explicit FullMeshDesk(News& news) : news_(news) {}

  /// The view of the frame's scene with the full mesh, which a level is judged against; empty where the
  /// settings draw the full mesh, where it is not there yet, and for another camera or scene while something
  /// is dragged (`hurry`). Errors (input, work): as `Pictures::refresh`.
  KeyedView refresh(Pipeline& pipeline, const Frame& frame, bool hurry);
  /// Reloads changed shaders of its own passes, if it has any. Errors and result: as of `Pipeline`.
  bool reload_changed_shaders() { return own_ && own_->pipeline.reload_changed_shaders(); }
  /// As `Pipeline::shader_problem`.
  std::string shader_problem() { return own_ ? own_->pipeline.shader_problem() : ""; }
  /// Frees what nobody looks at; to be called again while lines are being found.
  void forget();

  /// Whether `refresh` gave nothing because it is still being made.
  bool is_behind() const { return behind_; }

 private:
  struct Own {
    Own(const std::shared_ptr<LineFinder>& finder, News& news)
        : pipeline(finder), reference(pipeline, news) {}
    Pipeline pipeline;
    ReferenceDesk reference;
  };
  bool refresh_lines(MeshStore& meshes, const Frame& full, bool hurry);

  News& news_;
  std::unique_ptr<Own> own_;
  Stage<std::shared_ptr<const Image>> edges_;
  bool behind_ = false;
};

}  // namespace inkbench
