// SPDX-License-Identifier: MIT
#include "pipeline/lines/reference_lines.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "pipeline/lines/mesh_lines.h"
#include "pipeline/lines/object_lines.h"
#include "pipeline/lines/projection.h"
#include "pipeline/lines/visibility.h"

namespace inkbench {
namespace {

/// Both ends of an edge by their coordinates, the smaller first: equal across meshes that share the edge.
using EdgePlace = std::array<double, 6>;

EdgePlace place_of(const glm::dvec3& a, const glm::dvec3& b) {
  const EdgePlace forward{a.x, a.y, a.z, b.x, b.y, b.z};
  const EdgePlace backward{b.x, b.y, b.z, a.x, a.y, a.z};
  return std::min(forward, backward);
}

class MeshExtractor {
 public:
  MeshExtractor(const SceneMesh& mesh, const Projection& projection, const DepthTest& test,
                ReferenceLines& result)
      : mesh_(mesh), projection_(projection), test_(test), result_(result) {}

  void extract() {
    const MeshTopology& topology = *mesh_.topology;
    const std::vector<Link> silhouettes = links_of(
        topology,
        silhouette_edges(topology, face_facings(topology, projection_.viewpoint(), projection_.mirrored())));
    const std::vector<Link> boundaries = links_of(topology, boundary_edges(topology, crease_angle()));
    add_links(LineClass::silhouette, topology.positions, silhouettes, kAnyTurnDeg, result_.polylines);
    add_links(LineClass::boundary, topology.positions, boundaries, kMaxTurnDeg, result_.polylines);
    if (mesh_.features == nullptr) return;
    add_creases(silhouettes, boundaries);
    for (const Polyline3& line : suggestive_contours(*mesh_.features, projection_.viewpoint()))
      add_line(line.line_class, line.points, result_.polylines);
    for (const Polyline3& line : mesh_.features->ridges_and_valleys)
      add_line(line.line_class, line.points, result_.polylines);
  }

 private:
  void add_line(LineClass line_class, std::span<const glm::dvec3> points, std::vector<Polyline>& lines) {
    for (const ProjectedLine& projected : projection_.project(points)) {
      for (const ProjectedLine& piece : visible_pieces(projected, test_)) {
        Polyline line{line_class, mesh_.object_id, {}};
        line.points.assign(piece.begin(), piece.end());
        lines.push_back(std::move(line));
      }
    }
  }

  void add_links(LineClass line_class, std::span<const glm::dvec3> positions, std::span<const Link> links,
                 double max_turn_deg, std::vector<Polyline>& lines) {
    for (const Chain& chain : chain_links(positions, links, max_turn_deg)) {
      std::vector<glm::dvec3> points;
      points.reserve(chain.size());
      for (const uint32_t point : chain) points.push_back(positions[point]);
      add_line(line_class, points, lines);
    }
  }

  void add_creases(std::span<const Link> silhouettes, std::span<const Link> boundaries) {
    const std::vector<glm::dvec3>& points = mesh_.features->crease_points;
    std::vector<EdgePlace> taken;
    for (const auto& links : {silhouettes, boundaries}) {
      for (const Link& link : links)
        taken.push_back(place_of(mesh_.topology->positions[link[0]], mesh_.topology->positions[link[1]]));
    }
    std::sort(taken.begin(), taken.end());
    std::vector<Link> free;
    for (const Link& link : mesh_.features->creases) {
      if (!std::binary_search(taken.begin(), taken.end(), place_of(points[link[0]], points[link[1]])))
        free.push_back(link);
    }
    add_links(LineClass::crease, points, free, kMaxTurnDeg, result_.polylines);
    add_links(LineClass::crease, points, mesh_.features->creases, kMaxTurnDeg, result_.whole_creases);
  }

  double crease_angle() const {
    return mesh_.features != nullptr ? mesh_.features->params.crease_angle_deg : kCreaseAngleDeg;
  }

  const SceneMesh& mesh_;
  const Projection& projection_;
  const DepthTest& test_;
  ReferenceLines& result_;
};

}  // namespace

ReferenceLines reference_lines(std::span<const SceneMesh> scene, const CameraParams& camera,
                               const Image& depth, const Image& object_id) {
  assert(depth.channels == 1 && object_id.channels == 1);
  assert(depth.width_px == object_id.width_px && depth.height_px == object_id.height_px);
  ReferenceLines result{depth.width_px, depth.height_px, {}, {}};
  const DepthTest test(depth, camera);
  for (const SceneMesh& mesh : scene) {
    const Projection projection(camera, depth.width_px, depth.height_px, mesh.model_to_world);
    MeshExtractor(mesh, projection, test, result).extract();
  }
  for (Polyline& line : object_lines(object_id, depth)) result.polylines.push_back(std::move(line));
  return result;
}

void draw_line(const Polyline& line, LineMap& map) {
  ProjectedLine points;
  for (const glm::vec2& point : line.points) points.emplace_back(point.x, point.y, 0.0);
  for (const LineSample& sample : sample_line(points)) {
    map.set(std::clamp(static_cast<int>(std::floor(sample.point.x)), 0, map.width_px() - 1),
            std::clamp(static_cast<int>(std::floor(sample.point.y)), 0, map.height_px() - 1));
  }
}

LineMap class_map(const ReferenceLines& lines, LineClass line_class) {
  LineMap map(lines.width_px, lines.height_px);
  const std::vector<Polyline>& source =
      line_class == LineClass::crease ? lines.whole_creases : lines.polylines;
  for (const Polyline& line : source) {
    if (line.line_class == line_class) draw_line(line, map);
  }
  return map;
}

LineMap tier_map(const ReferenceLines& lines, const JudgeParams& judge, int wanted_tier) {
  LineMap map(lines.width_px, lines.height_px);
  for (const LineClass line_class : kLineClasses) {
    if (tier(judge, line_class) == wanted_tier) map = united(map, class_map(lines, line_class));
  }
  return map;
}

}  // namespace inkbench
