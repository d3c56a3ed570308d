// SPDX-License-Identifier: MIT
#include "pipeline/lines/features.h"

#include <glm/matrix.hpp>
#include <limits>
#include <string>

#include "pipeline/base/text.h"

namespace inkbench {
namespace {

/// The number that a person wrote: 0.3 and not the float beside it.
double as_written(float value) {
  return std::stod(shortest(value));
}

void unstretch(std::vector<Polyline3>& lines, const glm::dmat3& stretch) {
  const glm::dmat3 inverse = glm::inverse(stretch);
  for (Polyline3& line : lines) {
    for (glm::dvec3& point : line.points) point = inverse * point;
  }
}

void find_creases(const MeshTopology& full, MeshFeatures& features) {
  constexpr uint32_t kUnused = std::numeric_limits<uint32_t>::max();
  std::vector<uint32_t> index(full.positions.size(), kUnused);
  features.creases =
      links_of(full, crease_edges(full, features.params.crease_angle_deg, features.params.stretch));
  for (Link& link : features.creases) {
    for (uint32_t& point : link) {
      if (index[point] == kUnused) {
        index[point] = static_cast<uint32_t>(features.crease_points.size());
        features.crease_points.push_back(full.positions[point]);
      }
      point = index[point];
    }
  }
}

}  // namespace

FeatureParams::FeatureParams(const JudgeParams& judge)
    : crease_angle_deg(as_written(judge.crease_angle)),
      smoothing(as_written(judge.smoothing)),
      smooth_lines{.suggestive_derivative = as_written(judge.suggestive_derivative),
                   .suggestive_angle_deg = as_written(judge.suggestive_angle),
                   .ridge_curvature = as_written(judge.ridge_curvature),
                   .ridge_sharpness = as_written(judge.ridge_sharpness),
                   .ridge_anisotropy = as_written(judge.ridge_anisotropy),
                   .weak_share = as_written(judge.weak_share),
                   .shortest = as_written(judge.shortest)} {}

MeshFeatures make_features(const MeshTopology& full, const FeatureParams& params) {
  MeshFeatures features;
  features.params = params;
  find_creases(full, features);
  features.surface = make_smooth_surface(full, params.crease_angle_deg, params.smoothing, params.stretch);
  features.ridges_and_valleys = ridges_and_valleys(features.surface, params.smooth_lines);
  unstretch(features.ridges_and_valleys, params.stretch);
  return features;
}

std::vector<Polyline3> suggestive_contours(const MeshFeatures& features, const Viewpoint& eye) {
  const glm::dmat3& stretch = features.params.stretch;
  std::vector<Polyline3> lines =
      suggestive_contours(features.surface, eye.in(stretch), features.params.smooth_lines);
  unstretch(lines, stretch);
  return lines;
}

}  // namespace inkbench
