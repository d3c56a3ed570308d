// SPDX-License-Identifier: MIT
#include "pipeline/curves/object_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "pipeline/curves/covered_runs.h"
#include "pipeline/curves/crossings.h"
#include "pipeline/curves/cusps.h"
#include "pipeline/curves/model_lines.h"
#include "pipeline/curves/nearest_silhouette.h"

namespace inkbench {
namespace {

/// Less of them is nothing to tell anybody.
constexpr double kDoubtfulPx = 5.0;

/// All models' lines in the world, in order of class.
std::vector<ViewLine> world_lines(std::span<const CurveModel> models, std::span<const ModelCuts> cuts,
                                  const CurveView& view, const CurvesParams& params) {
  std::vector<ViewLine> lines;
  const auto add = [&](std::vector<ViewLine> more) {
    std::move(more.begin(), more.end(), std::back_inserter(lines));
  };
  for (size_t i = 0; i < models.size(); ++i) {
    const auto index = static_cast<int>(i);
    add(mesh_edge_lines(models[i], index, view, params, pierced_edges(models, cuts, index)));
    add(surface_lines(models[i], index, view, params));
  }
  for (const ModelCuts& cut : cuts) add(cut_lines(models, cut));
  std::stable_sort(lines.begin(), lines.end(),
                   [](const ViewLine& a, const ViewLine& b) { return a.line_class < b.line_class; });
  return lines;
}

/// What could not be decided, where it is long enough to see.
std::vector<std::string> notes_on(std::span<const ViewEdge> edges, const std::vector<ViewLine>& lines) {
  double doubtful_px = 0.0;
  double all_px = 0.0;
  for (const ViewEdge& edge : edges) {
    if (!lines[edge.line].is_drawn) continue;
    all_px += edge.length_px;
    if (edge.is_doubtful) doubtful_px += edge.length_px;
  }
  if (doubtful_px < kDoubtfulPx) return {};
  return {
      fmt::format("what covers {:.0f} of {:.0f} px of curves is doubtful: rays along them disagree, as "
                  "where surfaces lie in one place",
                  doubtful_px, all_px)};
}

}  // namespace

Curves object_curves(std::span<const CurveModel> models, std::span<const ModelCuts> cuts,
                     const CameraParams& camera, int width_px, int height_px, const CurvesParams& params) {
  const CurveView view(camera, width_px, height_px);
  std::vector<ViewLine> lines;
  for (const ViewLine& line : world_lines(models, cuts, view, params)) add_to_view(line, view, lines);
  split_at_crossings(lines, width_px, height_px);
  mark_cusps(models, view, lines);
  const bool some_follow =
      std::any_of(lines.begin(), lines.end(), [](const ViewLine& line) { return line.follows; });
  if (!some_follow) std::erase_if(lines, [](const ViewLine& line) { return !line.is_drawn; });

  std::vector<ViewEdge> edges = view_edges(lines);
  const Covering covering(models, view);
  decide_covering(edges, lines, covering);
  if (some_follow) follow_silhouettes(edges, lines, covering);
  return {width_px, height_px, curves_of(lines, edges, models, view), notes_on(edges, lines)};
}

}  // namespace inkbench
