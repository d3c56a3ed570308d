// SPDX-License-Identifier: MIT
// A buffer: what a pass makes that people can see, by the name that files, specs and the command line use.
// Each is described once, beside its pass; `all_buffers` (pipeline/buffers.h) lists them.
#pragma once

#include <compare>
#include <map>
#include <string_view>

#include "pipeline/settings/display_params.h"

namespace inkbench {

/// How values become a picture.
enum class ShownAs {
  grey,        ///< One channel, times the gain.
  colour,      ///< The first three channels as they are.
  object_id,   ///< Each id in a colour of its own.
  edge_class,  ///< Each class of drawn lines (EdgeClass) in a colour of its own.
  offset,      ///< The first two channels as red and green, half where they are 0.
  drawing,     ///< Curves, drawn in colours of their own.
};

/// How an image file of it reads as a line map.
enum class ReadAsLines {
  no,       ///< It shows no lines.
  at_cut,   ///< A strength: from a cut on.
  above_0,  ///< What a detector gives: wherever it is not 0.
  classes,  ///< Each pixel says the classes of its lines (pipeline/lines/class_pixels.h).
};

struct BufferInfo {
  std::string_view name;
  std::string_view help;  ///< One sentence for a person.
  int number_key = -1;    ///< The digit (0 to 9) that shows it in the window; -1: none.
  int first_channel = 0;  ///< In the pass's texture.
  int channels = 1;       ///< Of its raw values.
  ShownAs shown_as = ShownAs::grey;
  float DisplayParams::*gain = nullptr;  ///< What its picture is multiplied by; 1 where there is none.
  ReadAsLines as_lines = ReadAsLines::no;
  bool is_supersampled = false;  ///< Whether its picture follows `image.supersample`.
  float limit = 0.0F;            ///< The value from which on there is a line, where others say less; 0: none.
  std::string_view matters_when =
      {};                   ///< What must be set for it to hold anything, with whole keys; "": nothing.
  bool looks_back = false;  ///< It holds nothing in a frame without one before it.
};

/// Which buffer: compared by identity, ordered by name. The constants are those that code refers to.
class BufferName {
 public:
  /// `info` must live as long as the program.
  constexpr explicit BufferName(const BufferInfo& info) : info_(&info) {}
  constexpr const BufferInfo& info() const { return *info_; }
  constexpr bool operator==(const BufferName&) const = default;
  constexpr std::strong_ordering operator<=>(const BufferName& other) const {
    return info_->name <=> other.info_->name;
  }

  static const BufferName normal;          ///< 0.5 N + 0.5, world space (3.4.1).
  static const BufferName depth;           ///< Linear depth / far, 0 to 1, 1 where no model is (3.4.2).
  static const BufferName normal_edges;    ///< Mean of the normal map's three gradients (3.4.3).
  static const BufferName depth_edges;     ///< Gradient of the depth map (3.4.3).
  static const BufferName combined_edges;  ///< 0, or the sum of both terms clamped to 1 (3.4.4).
  static const BufferName lines;           ///< 1 where a line is drawn, else 0: what is measured.
  static const BufferName coverage;        ///< How much of a pixel is ink, 0 to 1.
  static const BufferName edge_strength;   ///< What the detector sees: 1 = at its limit, without an end.
  static const BufferName edge_class;      ///< EdgeClass of detected pixels, 0 elsewhere.
  static const BufferName pair_angles;     ///< Degrees to the surfaces on the right and above, signed.
  static const BufferName pair_gaps;       ///< The gaps to them in pixels' sizes, signed.
  static const BufferName shaded;          ///< Light through the ramps, no ink (3.1, 3.2).
  static const BufferName curves;          ///< Curves by class, over white.
  static const BufferName strokes;         ///< Strokes over white; alpha: what they hide.
  static const BufferName final;           ///< Ink over the shading (3.5).
  static const BufferName blinn_phong;     ///< Plain Blinn-Phong, whatever the ramps (3.1).
  static const BufferName object_id;  ///< 1, 2, ... in the scene's order of models, 0 where there is none.
  static const BufferName reference;  ///< Lines in object space, by class.
  static const BufferName motion;     ///< px to where each point stood in the frame before.
  static const BufferName visible_depth;  ///< From the nearest visible surface, 0, to the farthest, 1.
  static const BufferName albedo;         ///< The material's colour.
  static const BufferName material_id;    ///< 1, 2, ... for materials that differ, 0 where no model is.

 private:
  const BufferInfo* info_;
};

constexpr std::string_view name_of(BufferName buffer) {
  return buffer.info().name;
}

/// Whether it holds values of which some can be shown as black and as white.
constexpr bool has_range(BufferName buffer) {
  return buffer.info().shown_as == ShownAs::grey || buffer.info().shown_as == ShownAs::colour;
}

/// The gain of its picture.
inline float gain_of(const DisplayParams& display, BufferName buffer) {
  return buffer.info().gain == nullptr ? 1.0F : display.*buffer.info().gain;
}

/// Something for each buffer, made when it is first asked for.
template <class T>
class PerBuffer {
 public:
  T& operator[](BufferName buffer) { return values_[buffer]; }
  const T& operator[](BufferName buffer) const {
    static const T kNone{};
    const auto found = values_.find(buffer);
    return found == values_.end() ? kNone : found->second;
  }
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }
  void clear() { values_.clear(); }

 private:
  std::map<BufferName, T> values_;
};

}  // namespace inkbench
