// SPDX-License-Identifier: MIT
#include "pipeline/curves/model_lines.h"

#include <algorithm>
#include <glm/matrix.hpp>
#include <iterator>
#include <unordered_map>

#include "pipeline/lines/chain.h"
#include "pipeline/lines/mesh_lines.h"

namespace inkbench {
namespace {

/// At a meeting of several lines those go on that turn less than this; silhouettes always do.
constexpr double kMaxTurnDeg = 60.0;
constexpr double kAnyTurnDeg = 180.0;

uint64_t pair_key(uint32_t a, uint32_t b) {
  return (static_cast<uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
}

glm::dvec3 in_world(const CurveModel& model, const glm::dvec3& point) {
  return glm::dvec3(model.to_world * glm::dvec4(point, 1.0));
}

class EdgeLines {
 public:
  EdgeLines(const CurveModel& model, int index, std::span<const PiercedEdge> pierced)
      : model_(model), topology_(model.source->topology()), index_(index), pierced_(pierced) {}

  void add(CurveClass line_class, const std::vector<uint32_t>& edges, bool covers, bool is_drawn = true) {
    std::unordered_map<uint64_t, uint32_t> edge_of;
    edge_of.reserve(edges.size());
    std::vector<Link> links;
    links.reserve(edges.size());
    for (const uint32_t edge : edges) {
      links.push_back(topology_.edges[edge].points);
      edge_of.emplace(pair_key(links.back()[0], links.back()[1]), edge);
    }
    const double max_turn = line_class == CurveClass::silhouette ? kAnyTurnDeg : kMaxTurnDeg;
    for (const Chain& chain : chain_links(topology_.positions, links, max_turn)) {
      ViewLine line;
      line.line_class = line_class;
      line.model = index_;
      line.covers = covers;
      line.is_drawn = is_drawn;
      line.is_closed = chain.size() > 2 && chain.front() == chain.back();
      add_point(line, chain[0]);
      for (size_t i = 1; i < chain.size(); ++i)
        add_step(line, chain[i - 1], chain[i], edge_of.at(pair_key(chain[i - 1], chain[i])));
      lines_.push_back(std::move(line));
    }
  }

  std::vector<ViewLine> take() { return std::move(lines_); }

 private:
  void add_point(ViewLine& line, uint32_t point) const {
    LinePoint added;
    added.world = in_world(model_, topology_.positions[point]);
    added.place = place_of(model_, PlaceKind::vertex, point);
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

uint64_t place_of(const CurveModel& model, PlaceKind kind, uint32_t index, uint32_t face) {
  constexpr uint64_t kFaces = 1U << 25U;
  return (static_cast<uint64_t>(model.object_id) << 52U) | (static_cast<uint64_t>(kind) << 50U) |
         ((index * kFaces + face % kFaces) & ((uint64_t{1} << 50U) - 1));
}

std::vector<PiercedEdge> pierced_edges(std::span<const CurveModel> models, std::span<const ModelCuts> cuts,
                                       int model) {
  std::vector<PiercedEdge> pierced;
  for (const ModelCuts& cut : cuts) {
    for (const Piercing& piercing : cut.cuts->piercings) {
      const int its = piercing.mesh == 0 ? cut.first : cut.second;
      if (its != model) continue;
      const CurveModel& owner = models[static_cast<size_t>(its)];
      pierced.push_back({piercing.edge, piercing.along,
                         place_of(owner, PlaceKind::piercing, piercing.edge, piercing.face)});
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

std::vector<ViewLine> smooth_silhouette_lines(const CurveModel& model, int index, const CurveView& view) {
  const CurveSource& source = *model.source;
  const glm::dmat3 unstretch = glm::inverse(source.stretch());
  std::vector<ViewLine> lines;
  for (const FaceLine& found :
       source.smooth_silhouettes().find(*source.surface(), viewpoint_in(model, view).in(source.stretch()))) {
    ViewLine line;
    line.line_class = CurveClass::silhouette;
    line.model = index;
    line.follows = true;
    line.is_closed = found.points.size() > 2 && found.points.front() == found.points.back();
    for (size_t i = 0; i < found.points.size(); ++i) {
      LinePoint added;
      added.world = in_world(model, unstretch * found.points[i]);
      added.place = place_of(model, PlaceKind::edge, found.crossings[i]);
      line.points.push_back(added);
    }
    line.steps.resize(found.faces.size());
    lines.push_back(std::move(line));
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
    line.is_closed = chain.size() > 2 && chain.front() == chain.back();
    for (const uint32_t point : chain) {
      const Piercing& piercing = cuts.cuts->piercings[point];
      const CurveModel& owner = models[static_cast<size_t>(piercing.mesh == 0 ? cuts.first : cuts.second)];
      LinePoint added;
      added.world = points[point];
      added.place = place_of(owner, PlaceKind::piercing, piercing.edge, piercing.face);
      line.points.push_back(added);
    }
    line.steps.resize(line.points.size() - 1);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace inkbench
