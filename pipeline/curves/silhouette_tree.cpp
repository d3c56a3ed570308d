// SPDX-License-Identifier: MIT
#include "pipeline/curves/silhouette_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/lines/mesh_lines.h"

namespace inkbench {
namespace {

/// What rounding may change of a sine; a node that is nearer to turning is looked into.
constexpr double kSlack = 1e-7;
/// Looking at an item costs no more than looking at a node.
constexpr uint32_t kLeafSize = 8;

std::vector<Box> boxes_of_items(std::span<const FacingItem> items) {
  std::vector<Box> boxes;
  boxes.reserve(items.size());
  for (const FacingItem& item : items) boxes.push_back(item.box);
  return boxes;
}

}  // namespace

SilhouetteTree::SilhouetteTree(std::span<const FacingItem> items)
    : tree_(boxes_of_items(items), kLeafSize), cones_(tree_.nodes().size()) {
  const auto each_normal = [&](const BoxTree::Node& node, const auto& use) {
    for (uint32_t i = node.first; i < node.first + node.count; ++i) {
      for (const glm::dvec3& normal : items[tree_.items()[i]].normals) {
        if (normal != glm::dvec3(0.0)) use(normal);
      }
    }
  };
  const auto widen = [](Cone& cone, double cosine) { cone.cosine = std::min(cone.cosine, cosine); };
  // A node's axis is the mean of all normals below it, its angle a bound by its children's.
  std::vector<glm::dvec3> sums(cones_.size(), glm::dvec3(0.0));
  for (size_t n = cones_.size(); n-- > 0;) {
    const BoxTree::Node& node = tree_.nodes()[n];
    if (node.count > 0) {
      each_normal(node, [&](const glm::dvec3& normal) { sums[n] += normal; });
    } else {
      sums[n] = sums[node.first] + sums[node.first + 1];
    }
    Cone& cone = cones_[n];
    const double length = glm::length(sums[n]);
    cone.axis = length > 0.0 ? sums[n] / length : glm::dvec3(0.0, 0.0, 1.0);
    if (node.count > 0) {
      each_normal(node, [&](const glm::dvec3& normal) { widen(cone, glm::dot(cone.axis, normal)); });
    } else {
      for (const uint32_t child : {node.first, node.first + 1}) {
        const double between = std::acos(std::clamp(glm::dot(cone.axis, cones_[child].axis), -1.0, 1.0));
        const double angle = between + std::acos(std::clamp(cones_[child].cosine, -1.0, 1.0));
        widen(cone, angle >= 3.14159265 ? -1.0 : std::cos(angle));
      }
    }
    cone.sine = std::sqrt(std::max(0.0, 1.0 - cone.cosine * cone.cosine));
  }
}

bool SilhouetteTree::may_turn(uint32_t node, const Viewpoint& eye) const {
  const Cone& cone = cones_[node];
  if (cone.cosine <= 0.0) return true;
  const Box& box = tree_.nodes()[node].box;
  const glm::dvec3 centre = 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high));
  const glm::dvec3 to_eye = eye.from(centre);
  const double distance = glm::length(to_eye);
  // The ways from the box to the eye lie within an angle of that from its centre, of this sine.
  const double spread = eye.is_at_infinity() ? 0.0 : 0.5 * glm::length(glm::dvec3(box.size())) / distance;
  if (!(spread < 1.0)) return true;
  const double spread_cosine = std::sqrt(1.0 - spread * spread);
  // All face one way if the angle to the axis differs from a right one by more than both angles in sum.
  const double cosine = cone.cosine * spread_cosine - cone.sine * spread;
  const double sine = cone.sine * spread_cosine + cone.cosine * spread;
  if (cosine <= 0.0) return true;
  return std::abs(glm::dot(cone.axis, to_eye)) / distance <= sine + kSlack;
}

size_t SilhouetteTree::visited(const Viewpoint& eye) const {
  size_t count = 0;
  tree_.walk(
      [&](uint32_t node) {
        ++count;
        return may_turn(node, eye);
      },
      [](uint32_t) {});
  return count;
}

EdgeSilhouettes::EdgeSilhouettes(const MeshTopology& topology) {
  std::vector<FacingItem> items;
  std::vector<glm::dvec3> normals;
  std::vector<size_t> starts;
  for (uint32_t e = 0; e < topology.edges.size(); ++e) {
    const auto uses = topology.uses_of(topology.edges[e]);
    if (uses.size() < 2) continue;
    edges.push_back(e);
    starts.push_back(normals.size());
    FacingItem item;
    for (const MeshTopology::Use& use : uses) {
      normals.push_back(topology.normals[use.face]);
      for (const uint32_t point : topology.faces[use.face])
        item.box.add(glm::vec3(topology.positions[point]));
    }
    items.push_back(item);
  }
  starts.push_back(normals.size());
  for (size_t i = 0; i < items.size(); ++i)
    items[i].normals = std::span(normals).subspan(starts[i], starts[i + 1] - starts[i]);
  tree = SilhouetteTree(items);
}

std::vector<uint32_t> EdgeSilhouettes::find(const MeshTopology& topology, const Viewpoint& eye,
                                            bool mirrored) const {
  std::vector<uint32_t> candidates;
  tree.each_candidate(eye, [&](uint32_t item) { candidates.push_back(edges[item]); });
  std::vector<uint32_t> found = silhouette_edges(topology, candidates, eye, mirrored);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace inkbench
