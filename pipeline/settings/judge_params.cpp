// SPDX-License-Identifier: MIT
#include "pipeline/settings/judge_params.h"

#include "pipeline/settings/settings.h"

namespace inkbench {
namespace {

std::vector<Field> line_fields() {
  return {
      field<&JudgeParams::crease_angle>(
          {.name = "crease_angle",
           .help = "Edges of the full mesh that bend more than this are creases.",
           .unit = "deg",
           .limits = {1, 179},
           .slider = {10, 90}}),
      field<&JudgeParams::smoothing>(
          {.name = "smoothing",
           .help = "How far normals and curvature are smoothed before lines are read from them.",
           .unit = "mean edge lengths",
           .limits = {0, 20},
           .slider = {0, 5}}),
      field<&JudgeParams::suggestive_derivative>(
          {.name = "suggestive_derivative",
           .help = "Suggestive contours: least change of the curvature towards the eye, in 1 / radius^2.",
           .limits = {0.01, 1000},
           .slider = {1, 30}}),
      field<&JudgeParams::suggestive_angle>(
          {.name = "suggestive_angle",
           .help = "Suggestive contours: least angle between the surface's normal and the view.",
           .unit = "deg",
           .limits = {0, 90}}),
      field<&JudgeParams::ridge_curvature>(
          {.name = "ridge_curvature",
           .help = "Ridges and valleys: least curvature across the line, in 1 / radius.",
           .limits = {0.1, 1000},
           .slider = {1, 30}}),
      field<&JudgeParams::ridge_sharpness>(
          {.name = "ridge_sharpness",
           .help = "Ridges and valleys: least sharpness; 0 on an arc, 3 on a parabola.",
           .limits = {0, 10},
           .slider = {0, 3}}),
      field<&JudgeParams::ridge_anisotropy>(
          {.name = "ridge_anisotropy",
           .help = "Ridges and valleys: largest curvature along the line, as a share of that across it.",
           .limits = {0, 1}}),
      field<&JudgeParams::weak_share>(
          {.name = "weak_share",
           .help = "A smooth line that is strong somewhere goes on down to this share of its threshold.",
           .limits = {0.01, 1}}),
      field<&JudgeParams::shortest>({.name = "shortest",
                                     .help = "Smooth lines that are shorter than this are left out.",
                                     .unit = "radii",
                                     .limits = {0, 10},
                                     .slider = {0, 0.3}}),
  };
}

std::vector<Field> demand_fields() {
  return {
      field<&JudgeParams::silhouette>(
          {.name = "silhouette", .help = "Whether a drawing must have silhouettes or may have them."}),
      field<&JudgeParams::boundary>({.name = "boundary", .help = "The same of the open edges of a mesh."}),
      field<&JudgeParams::crease>({.name = "crease", .help = "The same of creases."}),
      field<&JudgeParams::object>({.name = "object", .help = "The same of borders between objects."}),
      field<&JudgeParams::suggestive>({.name = "suggestive", .help = "The same of suggestive contours."}),
      field<&JudgeParams::ridge>({.name = "ridge", .help = "The same of ridges."}),
      field<&JudgeParams::valley>({.name = "valley", .help = "The same of valleys."}),
  };
}

Description make_description() {
  Description description{
      "judge",
      "Judging drawn lines",
      {field<&JudgeParams::tolerance>({.name = "tolerance",
                                       .help = "How far a drawn line may lie from where it belongs.",
                                       .unit = "px",
                                       .limits = {0, 100},
                                       .slider = {0, 10}})}};
  for (const auto& fields : {line_fields(), demand_fields()})
    description.fields.insert(description.fields.end(), fields.begin(), fields.end());
  return description;
}

}  // namespace

const Description& JudgeParams::description() {
  static const Description kDescription = make_description();
  return kDescription;
}

std::string lines_text(const JudgeParams& judge) {
  static const Description kLines{"judge", "Reference lines", line_fields()};
  return group_text(kLines, &judge);
}

std::string judge_text(const JudgeParams& judge) {
  return group_text(judge);
}

}  // namespace inkbench
