// SPDX-License-Identifier: MIT
// The reference lines in the window. In: the settings, once a frame. Out: the newest lines that were found,
// perhaps of settings a moment ago, and textures of them. They are found beside the window.
#pragma once

#include <memory>
#include <optional>

#include "app/workbench/live_judge.h"
#include "app/workbench/live_reference.h"
#include "pipeline/gl/texture.h"
#include "pipeline/pipeline.h"

namespace inkbench {

/// What is judged, and what it was made from; empty where there is nothing (yet).
struct KeyedView {
  JudgedView view;
  Key key;
};

class ReferenceDesk {
 public:
  /// Both must outlive it.
  ReferenceDesk(Pipeline& pipeline, News& news) : finder_(pipeline.line_finder(), news) {}

  /// Takes in what was found and asks for the lines of the settings if they are others. Errors (input, work):
  /// as `Frame::line_request`; the lines of these settings could not be found.
  void refresh(const Frame& frame);
  /// The same, and waits for them.
  void finish(const Frame& frame);

  /// The newest lines; null before the first ones.
  const FoundLines* now() const { return now_ ? &*now_ : nullptr; }
  /// Whether `now` is of other settings than the last ones seen.
  bool is_behind() const { return behind_; }
  /// Whether lines are being found.
  bool is_busy() const { return finder_.is_busy(); }

  /// Of `now`, which must be there: the picture, and the lines to lay over others.
  const Texture& picture();
  const Texture& overlay();

 private:
  std::optional<FoundLines> now_;
  bool behind_ = false;
  Stage<Texture> picture_, overlay_;
  LiveReference finder_;
};

}  // namespace inkbench
