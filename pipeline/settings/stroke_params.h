// SPDX-License-Identifier: MIT
// A stroke style: how curves look when a hand draws them. Width and what it follows, ends, unsteadiness,
// paint, and what each class has of its own.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/params/description.h"
#include "pipeline/settings/curve_class.h"
#include "pipeline/settings/line_params.h"

namespace inkbench {

enum class StrokeColour { ink, by_class, material, shading };
template <>
struct ChoiceNames<StrokeColour> {
  static constexpr std::array<std::string_view, 4> names{"ink", "class", "material", "shading"};
};

enum class Brush { solid, ink, pencil, charcoal, marker, image };
template <>
struct ChoiceNames<Brush> {
  static constexpr std::array<std::string_view, 6> names{"solid",    "ink",    "pencil",
                                                         "charcoal", "marker", "image"};
};

enum class BrushFit { tile, stretch };
template <>
struct ChoiceNames<BrushFit> {
  static constexpr std::array<std::string_view, 2> names{"tile", "stretch"};
};

struct StrokeParams {
  // Width.
  float width = 2.0F;
  WidthUnit unit = WidthUnit::px;
  float outline = 1.0F;
  float depth_taper = 0.0F;
  float curvature_width = 0.0F;
  float shadow_width = 0.0F;
  float taper_in = 0.0F;
  float taper_out = 0.0F;
  float tip = 0.0F;
  std::string profile;
  // Course.
  float overshoot = 0.0F;
  float bridge = 0.0F;
  float shortest = 0.0F;
  float smoothing = 0.0F;
  float wobble = 0.0F;
  float wobble_length = 40.0F;
  int passes = 1;
  float spread = 1.0F;
  int seed = 1;
  // Paint.
  StrokeColour colour = StrokeColour::ink;
  float darken = 0.5F;
  float opacity = 1.0F;
  Brush brush = Brush::solid;
  std::string brush_image;
  float brush_length = 64.0F;
  BrushFit brush_fit = BrushFit::tile;
  float grain = 0.5F;
  bool coherent = true;
  // Hidden lines.
  bool hidden = false;
  float hidden_width = 0.6F;
  float hidden_opacity = 0.6F;
  float dash = 6.0F;
  float dash_gap = 4.0F;

  static const Description& description();
};

/// Of one class of curves.
struct StrokeClassParams {
  float width = 1.0F;
  glm::vec3 colour{0.0F};
  float opacity = 1.0F;

  static const Description& description();
};
using StrokeClasses = std::array<StrokeClassParams, kCurveClasses>;

/// Colours that tell the classes apart, for all readers.
StrokeClasses default_stroke_classes();

/// A share of the width at a place along a stroke, both 0 to 1.
struct ProfilePoint {
  float along = 0.0F, share = 1.0F;
};
/// "0 0.2, 0.5 1, 1 0": points in order of `along`; between them the share is linear, before the first and
/// after the last it stays. Empty: 1 everywhere. Errors (input), with `where`: no such list.
std::vector<ProfilePoint> parse_profile(std::string_view text, const std::string& where);
/// What `parse_profile` reads.
std::string profile_text(const std::vector<ProfilePoint>& profile);

}  // namespace inkbench
