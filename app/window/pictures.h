// SPDX-License-Identifier: MIT
// The buffers' pictures as the window shows them: those of the settings now, and those of an earlier state
// that was pinned. They are the pipeline's own pictures, left on the GPU; what is unchanged is a lookup.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/window/reference_desk.h"
#include "pipeline/explain.h"
#include "pipeline/pipeline.h"

namespace inkbench {

/// A picture to show; `texture` is nullptr while there is none.
struct ShownPicture {
  const Texture* texture = nullptr;
  Key key;
  std::optional<ShownRange> range;  ///< What is black and white, where the display gains do not say.
  bool is_late = false;             ///< Of earlier settings: the present ones' is still being made.
};

/// How a buffer's values become a picture. Of the window only: files are written with the display gains.
struct PictureChoice {
  enum class Kind { gains, fitted, fixed };
  Kind kind = Kind::gains;
  ShownRange fixed;
};

/// From any range to the fitted one, and from that to the display gains.
void toggle_fit(PictureChoice& choice);

/// Needs a current OpenGL 4.5 context for its whole life. To make one, errors (input): a shader does not
/// compile.
class Pictures {
 public:
  /// `news` must outlive it.
  explicit Pictures(News& news) : reference_(pipeline_, news) {}

  /// Draws the `wanted` ones that are not up to date; reference lines are found beside the window. Of large
  /// images only as much as a moment allows, at least one picture and `first` before the others; the rest is
  /// late. Errors (input, work): what cannot be drawn; that picture and those after it stay as they were.
  void refresh(const Frame& frame, std::vector<BufferName> wanted, BufferName first);

  const ShownPicture& shown(BufferName buffer, bool pinned) const;
  /// Whether a picture waits for another refresh.
  bool has_late() const;

  PictureChoice& choice(BufferName buffer) { return choices_[buffer]; }

  /// Keeps the pictures as they are now, to compare with. Errors as `refresh`.
  void pin(const Frame& frame);
  void unpin();
  const std::optional<Settings>& pinned_settings() const { return pinned_settings_; }
  /// What explains the pinned state's pixels; nothing where nothing is pinned.
  const std::optional<KeptMaps>& pinned_maps() const { return pinned_maps_; }
  /// The pinned state's edges and reference lines; empty where nothing is pinned.
  const KeyedView& pinned_view() const { return pinned_view_; }

  Pipeline& pipeline() { return pipeline_; }
  const Pipeline& pipeline() const { return pipeline_; }
  ReferenceDesk& reference() { return reference_; }
  const ReferenceDesk& reference() const { return reference_; }

 private:
  void refresh_large(const Frame& frame, std::span<const BufferName> buffers);
  void refresh_one(const Frame& frame, BufferName buffer);
  void refresh_reference(const Frame& frame);
  ShownRange fitted_range(const Frame& frame, BufferName buffer);

  Pipeline pipeline_;
  PerBuffer<PictureChoice> choices_;
  PerBuffer<ShownPicture> now_, pinned_;
  PerBuffer<Stage<ShownRange>> ranges_;
  PerBuffer<Texture> pinned_textures_;
  std::optional<Settings> pinned_settings_;
  std::optional<KeptMaps> pinned_maps_;
  KeyedView pinned_view_;
  ReferenceDesk reference_;
};

}  // namespace inkbench
