// The reference lines in the window. In: the settings, once a frame. Out: the newest lines that were found,
// perhaps of settings a moment ago, and textures of them. They are found beside the window.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "app/workbench/live_reference.h"
#include "pipeline/gl/texture.h"
#include "pipeline/pipeline.h"

namespace inkbench {

class ReferenceDesk {
 public:
  /// `pipeline` must outlive it.
  explicit ReferenceDesk(Pipeline& pipeline);

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
  /// Whether there are new lines since the last call: a frame should show them.
  bool take_news() { return news_.exchange(false); }

  /// Of `now`, which must be there: the picture, and the lines to lay over others.
  const Texture& picture();
  const Texture& overlay();

 private:
  std::optional<FoundLines> now_;
  Key asked_;
  bool behind_ = false;
  Stage<Texture> picture_, overlay_;
  std::atomic<bool> news_ = false;
  LiveReference finder_;  ///< Last: its thread writes `news_`.
};

}  // namespace inkbench
