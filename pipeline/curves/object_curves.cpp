// SPDX-License-Identifier: MIT
#include "pipeline/curves/object_curves.h"

#include <algorithm>

#include "pipeline/curves/covered_runs.h"
#include "pipeline/curves/crossings.h"
#include "pipeline/curves/cusps.h"
#include "pipeline/curves/model_lines.h"

namespace inkbench {
namespace {

/// Is the class drawn?
bool is_wanted(const CurvesParams& params, CurveClass line_class) {
  switch (line_class) {
    case CurveClass::silhouette:
      return params.silhouette != SilhouetteKind::off;
    case CurveClass::boundary:
      return params.boundary;
    default:
      return true;  // What is not asked for is not looked for.
  }
}

}  // namespace

Curves object_curves(std::span<const CurveModel> models, std::span<const ModelCuts> cuts,
                     const CameraParams& camera, int width_px, int height_px, const CurvesParams& params) {
  const CurveView view(camera, width_px, height_px);
  std::vector<ViewLine> world_lines;
  for (size_t i = 0; i < models.size(); ++i) {
    const auto index = static_cast<int>(i);
    const std::vector<PiercedEdge> pierced = pierced_edges(models, cuts, index);
    for (ViewLine& line : mesh_edge_lines(models[i], index, view, params, pierced))
      world_lines.push_back(std::move(line));
  }
  for (const ModelCuts& cut : cuts) {
    for (ViewLine& line : cut_lines(models, cut)) world_lines.push_back(std::move(line));
  }
  std::stable_sort(world_lines.begin(), world_lines.end(),
                   [](const ViewLine& a, const ViewLine& b) { return a.line_class < b.line_class; });

  std::vector<ViewLine> lines;
  for (const ViewLine& line : world_lines) add_to_view(line, view, lines);
  split_at_crossings(lines, width_px, height_px);
  for (ViewLine& line : lines) {
    const CurveModel& model = models[static_cast<size_t>(line.model)];
    if (line.covers) mark_cusps(*model.source, model.to_world, view, line);
  }
  std::erase_if(lines, [&](const ViewLine& line) { return !is_wanted(params, line.line_class); });

  std::vector<ViewEdge> edges = view_edges(lines);
  decide_covering(edges, lines, Covering(models, view));
  return {width_px, height_px, curves_of(lines, edges, models, view), {}};
}

}  // namespace inkbench
