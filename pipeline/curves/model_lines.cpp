// SPDX-License-Identifier: MIT
#include "pipeline/curves/model_lines.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <iterator>

#include "pipeline/lines/apparent_ridges.h"
#include "pipeline/lines/chain.h"
#include "pipeline/lines/mesh_lines.h"

namespace inkbench {
namespace {

enum class PlaceKind { vertex, piercing, crossing };

/// Whether a line ends where it starts.
template <class Points>
bool is_ring(const Points& points) {
  return points.size() > 2 && points.front() == points.back();
}

uint64_t place_id(const CurveModel& model, uint64_t kind, uint64_t index) {
  return (static_cast<uint64_t>(model.object_id) << 52U) | (kind << 48U) |
         (index & ((uint64_t{1} << 48U) - 1));
}

glm::dvec3 in_world(const CurveModel& model, const glm::dvec3& point) {
  return glm::dvec3(model.to_world * glm::dvec4(point, 1.0));
}

class EdgeLines {
 public:
  EdgeLines(const CurveModel& model, int index, std::span<const PiercedEdge> pierced)
      : model_(model), topology_(model.source->topology()), index_(index), pierced_(pierced) {}

  void add(CurveClass line_class, const std::vector<uint32_t>& edges, bool covers, bool is_drawn = true) {
    std::vector<Link> links;
    links.reserve(edges.size());
    for (const uint32_t edge : edges) links.push_back(topology_.edges[edge].points);
    const double max_turn = line_class == CurveClass::silhouette ? kAnyTurnDeg : kMaxTurnDeg;
    for (const LinkedChain& chain : linked_chains(topology_.positions, links, max_turn)) {
      ViewLine& line = lines_.emplace_back();
      line.line_class = line_class;
      line.model = index_;
      line.covers = covers;
      line.is_drawn = is_drawn;
      line.is_closed = is_ring(chain.points);
      line.points.reserve(chain.points.size());
      line.steps.reserve(chain.links.size());
      add_point(line, chain.points[0]);
      for (size_t i = 0; i < chain.links.size(); ++i)
        add_step(line, chain.points[i], chain.points[i + 1], edges[chain.links[i]]);
    }
  }

  std::vector<ViewLine> take() { return std::move(lines_); }

 private:
  void add_point(ViewLine& line, uint32_t point) const {
    LinePoint added;
    added.world = in_world(model_, topology_.positions[point]);
    added.place = vertex_place(model_, point);
    line.points.push_back(added);
  }

  /// With a point where the edge goes through a face.
  void add_step(ViewLine& line, uint32_t from, uint32_t to, uint32_t edge) const {
    const auto [first, last] =
        std::equal_range(pierced_.begin(), pierced_.end(), PiercedEdge{edge, 0.0, 0},
                         [](const PiercedEdge& a, const PiercedEdge& b) { return a.edge < b.edge; });
    std::vector<PiercedEdge> on_edge(first, last);
    const auto& ends = topology_.edges[edge].points;
    if (from != ends[0]) std::reverse(on_edge.begin(), on_edge.end());
    for (const PiercedEdge& piercing : on_edge) {
      const glm::dvec3& a = topology_.positions[ends[0]];
      LinePoint added;
      added.world = in_world(model_, a + piercing.along * (topology_.positions[ends[1]] - a));
      added.place = piercing.place;
      added.change = CurveEnd::junction;
      line.steps.push_back({edge});
      line.points.push_back(added);
    }
    line.steps.push_back({edge});
    add_point(line, to);
  }

  const CurveModel& model_;
  const MeshTopology& topology_;
  int index_;
  std::span<const PiercedEdge> pierced_;
  std::vector<ViewLine> lines_;
};

/// A face's height over its longest side, in the world.
double height_of(const CurveModel& model, uint32_t face) {
  const MeshTopology& topology = model.source->topology();
  std::array<glm::dvec3, 3> corners;
  for (size_t i = 0; i < 3; ++i) corners[i] = in_world(model, topology.positions[topology.faces[face][i]]);
  const double twice_area = glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  const double longest =
      std::max({glm::distance(corners[0], corners[1]), glm::distance(corners[1], corners[2]),
                glm::distance(corners[2], corners[0])});
  return longest > 0.0 ? twice_area / longest : 0.0;
}

Viewpoint viewpoint_in(const CurveModel& model, const CurveView& view) {
  const Viewpoint eye = view.viewpoint();
  if (eye.is_at_infinity()) return eye.in(glm::dmat3(model.to_mesh));
  return glm::dvec3(model.to_mesh * glm::dvec4(eye.from(glm::dvec3(0.0)), 1.0));
}

std::vector<uint32_t> without(const std::vector<uint32_t>& edges, const std::vector<uint32_t>& taken) {
  std::vector<uint32_t> rest;
  std::set_difference(edges.begin(), edges.end(), taken.begin(), taken.end(), std::back_inserter(rest));
  return rest;
}

}  // namespace

uint64_t vertex_place(const CurveModel& model, uint32_t vertex) {
  return place_id(model, static_cast<uint64_t>(PlaceKind::vertex), vertex);
}

uint64_t piercing_place(const CurveModel& model, const Piercing& piercing) {
  constexpr uint64_t kHalf = 1U << 24U;
  return place_id(model, static_cast<uint64_t>(PlaceKind::piercing),
                  piercing.edge * kHalf + piercing.face % kHalf);
}

uint64_t crossing_place(const CurveModel& model, CurveClass line_class, uint32_t crossing) {
  return place_id(model, static_cast<uint64_t>(PlaceKind::crossing) + static_cast<uint64_t>(line_class),
                  crossing);
}

std::vector<PiercedEdge> pierced_edges(std::span<const CurveModel> models, std::span<const ModelCuts> cuts,
                                       int model) {
  std::vector<PiercedEdge> pierced;
  for (const ModelCuts& cut : cuts) {
    for (const Piercing& piercing : cut.cuts->piercings) {
      const int its = piercing.mesh == 0 ? cut.first : cut.second;
      if (its != model) continue;
      const CurveModel& owner = models[static_cast<size_t>(its)];
      pierced.push_back({piercing.edge, piercing.along, piercing_place(owner, piercing)});
    }
  }
  std::sort(pierced.begin(), pierced.end());
  return pierced;
}

std::vector<ViewLine> mesh_edge_lines(const CurveModel& model, int index, const CurveView& view,
                                      const CurvesParams& params, std::span<const PiercedEdge> pierced) {
  const CurveSource& source = *model.source;
  const bool mirrored = glm::determinant(glm::dmat3(model.to_world)) < 0.0;
  const std::vector<uint32_t> silhouettes =
      source.silhouettes().find(source.topology(), viewpoint_in(model, view), mirrored);
  EdgeLines lines(model, index, pierced);
  if (params.silhouette == SilhouetteKind::smooth) {
    std::vector<uint32_t> parted;
    std::copy_if(silhouettes.begin(), silhouettes.end(), std::back_inserter(parted),
                 [&](uint32_t edge) { return source.is_parted(edge); });
    lines.add(CurveClass::silhouette, parted, true);
    lines.add(CurveClass::silhouette, without(silhouettes, parted), true, false);
  } else {
    lines.add(CurveClass::silhouette, silhouettes, true, params.silhouette == SilhouetteKind::mesh);
  }
  lines.add(CurveClass::boundary, without(source.boundaries(), silhouettes), true, params.boundary);
  if (params.crease) lines.add(CurveClass::crease, without(source.creases(), silhouettes), false);
  return lines.take();
}

std::vector<ViewLine> surface_lines(const CurveModel& model, int index, const CurveView& view,
                                    const CurvesParams& params) {
  std::vector<ViewLine> lines;
  const CurveSource& source = *model.source;
  if (source.surface() == nullptr) return lines;
  const SmoothSurface& surface = *source.surface();
  const glm::dmat3 unstretch = glm::inverse(source.stretch());
  const Viewpoint eye = viewpoint_in(model, view).in(source.stretch());
  const auto add = [&](CurveClass line_class, const auto& found) {
    ViewLine& line = lines.emplace_back();
    line.line_class = line_class;
    line.model = index;
    line.follows = line_class == CurveClass::silhouette;
    line.is_closed = is_ring(found.points);
    for (size_t i = 0; i < found.points.size(); ++i) {
      LinePoint& added = line.points.emplace_back();
      added.world = in_world(model, unstretch * found.points[i]);
      if (found.crossings[i] < surface.crossing_count)
        added.place = crossing_place(model, line_class, found.crossings[i]);
    }
    line.steps.resize(found.points.size() - 1);
    if (!line.follows) return;
    for (size_t i = 0; i < line.steps.size(); ++i) line.steps[i].across = height_of(model, found.faces[i]);
  };
  if (params.silhouette == SilhouetteKind::smooth) {
    for (const SurfaceLine& line : source.smooth_silhouettes().find(surface, eye))
      add(CurveClass::silhouette, line);
  }
  if (params.suggestive) {
    const SmoothLineParams limits =
        smooth_line_params(params, params.ridge_limit, surface, source.feature_size());
    for (const Polyline3& line : suggestive_contours(surface, eye, limits)) add(CurveClass::suggestive, line);
  }
  for (const Polyline3& line : source.ridges_and_valleys())
    add(line.line_class == LineClass::ridge ? CurveClass::ridge : CurveClass::valley, line);
  if (params.apparent_ridge && source.feature_size() > 0.0) {
    const ApparentRidgeParams limits{.limit = params.apparent_limit / source.feature_size(),
                                     .weak_share = params.weak_share,
                                     .shortest = params.shortest * source.feature_size()};
    for (const SurfaceLine& line : apparent_ridges(surface, eye, limits))
      add(CurveClass::apparent_ridge, line);
  }
  return lines;
}

std::vector<ViewLine> cut_lines(std::span<const CurveModel> models, const ModelCuts& cuts) {
  const CurveModel& first = models[static_cast<size_t>(cuts.first)];
  std::vector<glm::dvec3> points;
  for (const Piercing& piercing : cuts.cuts->piercings) points.push_back(in_world(first, piercing.at));
  std::vector<ViewLine> lines;
  for (const Chain& chain : chain_links(points, cuts.cuts->pieces, kMaxTurnDeg)) {
    ViewLine line;
    line.line_class = CurveClass::intersection;
    line.model = cuts.first;
    line.is_closed = is_ring(chain);
    for (const uint32_t point : chain) {
      const Piercing& piercing = cuts.cuts->piercings[point];
      const CurveModel& owner = models[static_cast<size_t>(piercing.mesh == 0 ? cuts.first : cuts.second)];
      LinePoint added;
      added.world = points[point];
      added.place = piercing_place(owner, piercing);
      line.points.push_back(added);
    }
    line.steps.resize(line.points.size() - 1);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace inkbench
