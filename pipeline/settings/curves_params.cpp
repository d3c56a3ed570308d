// SPDX-License-Identifier: MIT
#include "pipeline/settings/curves_params.h"

namespace inkbench {
namespace {

constexpr std::string_view kOfObjects = "curves.from != image";

std::vector<Field> class_fields() {
  return {
      field<&CurvesParams::from>(
          {.name = "from",
           .help = "object: curves of the meshes, with what hides them; image: the lines that edges.method "
                   "finds, traced; or both."}),
      field<&CurvesParams::silhouette>(
          {.name = "silhouette",
           .help = "mesh: edges between a face that faces the eye and one that does not; smooth: where "
                   "interpolated normals turn away, which runs more evenly; or off.",
           .matters_when = kOfObjects}),
      field<&CurvesParams::boundary>(
          {.name = "boundary", .help = "Open edges of meshes.", .matters_when = kOfObjects}),
      field<&CurvesParams::crease>(
          {.name = "crease", .help = "Edges that bend more than crease_angle.", .matters_when = kOfObjects}),
      field<&CurvesParams::intersection>({.name = "intersection",
                                          .help = "Where surfaces cut each other, of two models or of one.",
                                          .matters_when = kOfObjects}),
      field<&CurvesParams::suggestive>({.name = "suggestive",
                                        .help = "Suggestive contours: where the surface nearly turns away.",
                                        .matters_when = kOfObjects}),
      field<&CurvesParams::ridge>(
          {.name = "ridge", .help = "Where a convex surface bends most.", .matters_when = kOfObjects}),
      field<&CurvesParams::valley>(
          {.name = "valley", .help = "Where a hollow surface bends most.", .matters_when = kOfObjects}),
      field<&CurvesParams::apparent_ridge>(
          {.name = "apparent_ridge",
           .help = "Apparent ridges: where the surface bends most as seen from the eye.",
           .matters_when = kOfObjects}),
  };
}

std::vector<Field> limit_fields() {
  return {
      field<&CurvesParams::crease_angle>({.name = "crease_angle",
                                          .help = "Edges that bend more than this are creases.",
                                          .unit = "deg",
                                          .limits = {1, 179},
                                          .slider = {10, 90},
                                          .matters_when = kOfObjects}),
      field<&CurvesParams::smoothing>(
          {.name = "smoothing",
           .help = "How far normals and curvature are smoothed before lines of the smooth surface are read "
                   "from them.",
           .unit = "mean edge lengths",
           .limits = {0, 20},
           .slider = {0, 5},
           .matters_when = kOfObjects}),
      field<&CurvesParams::suggestive_limit>(
          {.name = "suggestive_limit",
           .help = "Least change of the curvature towards the eye, in 1 / feature size^2.",
           .limits = {0.0001, 10},
           .slider = {0.001, 0.1},
           .scale = Scale::log,
           .matters_when = "curves.suggestive = true"}),
      field<&CurvesParams::suggestive_angle>(
          {.name = "suggestive_angle",
           .help = "Least angle between the surface's normal and the view.",
           .unit = "deg",
           .limits = {0, 90},
           .matters_when = "curves.suggestive = true"}),
      field<&CurvesParams::ridge_limit>({.name = "ridge_limit",
                                         .help = "Least curvature across a ridge, in 1 / feature size.",
                                         .limits = {0.001, 100},
                                         .slider = {0.01, 1},
                                         .scale = Scale::log,
                                         .matters_when = "curves.ridge = true"}),
      field<&CurvesParams::valley_limit>({.name = "valley_limit",
                                          .help = "Least curvature across a valley, in 1 / feature size.",
                                          .limits = {0.001, 100},
                                          .slider = {0.01, 1},
                                          .scale = Scale::log,
                                          .matters_when = "curves.valley = true"}),
      field<&CurvesParams::apparent_limit>(
          {.name = "apparent_limit",
           .help = "Least curvature as the eye sees it, in 1 / feature size.",
           .limits = {0.001, 100},
           .slider = {0.01, 1},
           .scale = Scale::log,
           .matters_when = "curves.apparent_ridge = true"}),
      field<&CurvesParams::weak_share>(
          {.name = "weak_share",
           .help = "A line of the smooth surface that is strong somewhere goes on down to this share of its "
                   "limit.",
           .limits = {0.01, 1},
           .matters_when = kOfObjects}),
      field<&CurvesParams::shortest>(
          {.name = "shortest",
           .help = "Lines of the smooth surface that are shorter than this are left out.",
           .unit = "feature sizes",
           .limits = {0, 1000},
           .slider = {0, 20},
           .matters_when = kOfObjects}),
      field<&CurvesParams::image_smoothing>(
          {.name = "image_smoothing",
           .help = "How far traced curves may leave the pixels' lines in order to run evenly.",
           .unit = "px",
           .limits = {0, 0.75},
           .matters_when = "curves.from != object"}),
  };
}

Description make_curves() {
  Description description{"curves", "Curves", class_fields(), {}};
  const std::vector<Field> limits = limit_fields();
  description.fields.insert(description.fields.end(), limits.begin(), limits.end());
  return description;
}

}  // namespace

const Description& CurvesParams::description() {
  static const Description kDescription = make_curves();
  return kDescription;
}

}  // namespace inkbench
