// The buffers' pictures as the window shows them: those of the settings now, and those of an earlier state
// that was pinned. They are the pipeline's own pictures, left on the GPU; what is unchanged is a lookup.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "app/window/reference_desk.h"
#include "app/workbench/live_judge.h"
#include "pipeline/pipeline.h"
#include "studies/judging/buffer_source.h"

namespace inkbench {

constexpr size_t kBufferCount = kBufferNames.size();

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

/// Whether it can be chosen which values are black and white.
constexpr bool has_range(BufferName buffer) {
  return buffer != BufferName::object_id && buffer != BufferName::reference;
}

/// From any range to the fitted one, and from that to the display gains.
void toggle_fit(PictureChoice& choice);

/// Needs a current OpenGL 4.5 context for its whole life. To make one, errors (input): a shader does not
/// compile.
class Pictures {
 public:
  /// Draws what `wanted` names and is not up to date; reference lines are found beside the window. Of large
  /// images only as much as a moment allows, at least one picture and `first` before the others; the rest is
  /// late. Errors (input, work): what cannot be drawn; that picture and those after it stay as they were.
  void refresh(const Settings& settings, const std::array<bool, kBufferCount>& wanted, BufferName first);

  const ShownPicture& shown(BufferName buffer, bool pinned) const;
  /// Whether a picture waits for another refresh.
  bool has_late() const;

  PictureChoice& choice(BufferName buffer) { return choices_[static_cast<size_t>(buffer)]; }

  /// Keeps the pictures as they are now, to compare with. Errors as `refresh`.
  void pin(const Settings& settings);
  void unpin();
  const std::optional<Settings>& pinned_settings() const { return pinned_settings_; }
  /// The pinned state's edges and reference lines; empty where nothing is pinned.
  const JudgedView& pinned_view() const { return pinned_view_; }

  Pipeline& pipeline() { return pipeline_; }
  const Pipeline& pipeline() const { return pipeline_; }
  BufferSource& source() { return source_; }
  ReferenceDesk& reference() { return reference_; }
  const ReferenceDesk& reference() const { return reference_; }

 private:
  void refresh_large(const Settings& settings, std::span<const BufferName> buffers);
  void refresh_one(const Settings& settings, BufferName buffer);
  void refresh_reference(const Settings& settings);
  ShownRange fitted_range(const Settings& settings, BufferName buffer);

  Pipeline pipeline_;
  BufferSource source_{pipeline_};
  std::array<PictureChoice, kBufferCount> choices_;
  std::array<ShownPicture, kBufferCount> now_, pinned_;
  std::array<Stage<ShownRange>, kBufferCount> ranges_;
  std::array<Texture, kBufferCount> pinned_textures_;
  std::optional<Settings> pinned_settings_;
  JudgedView pinned_view_;
  ReferenceDesk reference_{source_};
};

}  // namespace inkbench
