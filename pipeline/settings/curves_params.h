// SPDX-License-Identifier: MIT
// Which curves are found: from the meshes, from the drawn lines, or both; of which classes, from which
// strength on. Thresholds are relative to a model's feature size, so that they fit any model
// (pipeline/curves/feature_size.h).
#pragma once

#include <array>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

enum class CurvesFrom { object, image, both };
template <>
struct ChoiceNames<CurvesFrom> {
  static constexpr std::array<std::string_view, 3> names{"object", "image", "both"};
};

/// `mesh`: edges between a front and a back face. `smooth`: where the interpolated normals turn away.
enum class SilhouetteKind { off, mesh, smooth };
template <>
struct ChoiceNames<SilhouetteKind> {
  static constexpr std::array<std::string_view, 3> names{"off", "mesh", "smooth"};
};

struct CurvesParams {
  CurvesFrom from = CurvesFrom::object;
  SilhouetteKind silhouette = SilhouetteKind::mesh;
  bool boundary = true;
  bool crease = true;
  bool intersection = true;
  bool suggestive = false;
  bool ridge = false;
  bool valley = false;
  bool apparent_ridge = false;
  float crease_angle = 40.0F;
  float smoothing = 2.0F;
  float suggestive_limit = 0.01F;
  float suggestive_angle = 20.0F;
  float ridge_limit = 0.1F;
  float valley_limit = 0.1F;
  float apparent_limit = 0.1F;
  float weak_share = 0.5F;
  float shortest = 4.0F;
  float image_smoothing = 0.75F;

  static const Description& description();
  bool operator==(const CurvesParams&) const = default;
};

}  // namespace inkbench
