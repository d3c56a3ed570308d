// SPDX-License-Identifier: MIT
// How drawn lines are judged: how far off a line may be, where the lines that should be there run, and which
// of them a drawing must have. No pass reads it; reference lines and measures do.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

/// `wanted` (tier 1): a drawing must have the line. `allowed` (tier 2): it may have it.
enum class Demand { wanted, allowed };
template <>
struct ChoiceNames<Demand> {
  static constexpr std::array<std::string_view, 2> names{"wanted", "allowed"};
};

struct JudgeParams {
  float tolerance = 2.0F;
  float crease_angle = 40.0F;
  float smoothing = 2.0F;
  float suggestive_derivative = 8.0F;
  float suggestive_angle = 20.0F;
  float ridge_curvature = 7.0F;
  float ridge_sharpness = 0.3F;
  float ridge_anisotropy = 0.6F;
  float weak_share = 0.5F;
  float shortest = 0.04F;
  Demand silhouette = Demand::wanted;
  Demand boundary = Demand::wanted;
  Demand crease = Demand::wanted;
  Demand object = Demand::wanted;
  Demand suggestive = Demand::allowed;
  Demand ridge = Demand::allowed;
  Demand valley = Demand::allowed;

  static const Description& description();
  bool operator==(const JudgeParams&) const = default;
};

/// What decides the reference lines, and all of it, as text for keys.
std::string lines_text(const JudgeParams& judge);
std::string judge_text(const JudgeParams& judge);

/// The tolerances that may be asked for, and the usual one.
inline constexpr double kToleranceFromPx = 0, kToleranceToPx = 100, kTolerancePx = JudgeParams{}.tolerance;

}  // namespace inkbench
