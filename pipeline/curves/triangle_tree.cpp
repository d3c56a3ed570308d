// SPDX-License-Identifier: MIT
#include "pipeline/curves/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace inkbench {
namespace {

constexpr double kOnPlaneShare = 2e-6;

std::vector<Box> boxes_of(const MeshTopology& topology) {
  std::vector<Box> boxes(topology.faces.size());
  for (size_t f = 0; f < boxes.size(); ++f) {
    for (const uint32_t point : topology.faces[f]) boxes[f].add(glm::vec3(topology.positions[point]));
  }
  return boxes;
}

/// A ray as the z axis: points are sheared onto it, so that a face is met where it holds the origin of x and
/// y. Points that faces share are sheared alike, so nothing falls between them.
/// Source: Woop, Benthin and Wald, "Watertight ray/triangle intersection", 2013.
class Shear {
 public:
  explicit Shear(const Ray& ray) : origin_(ray.origin) {
    const glm::dvec3 size = glm::abs(ray.direction);
    z_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    slope_x_ = ray.direction[x_] / ray.direction[z_];
    slope_y_ = ray.direction[y_] / ray.direction[z_];
  }

  glm::dvec2 operator()(const glm::dvec3& point) const {
    const glm::dvec3 from = point - origin_;
    return {from[x_] - slope_x_ * from[z_], from[y_] - slope_y_ * from[z_]};
  }

 private:
  glm::dvec3 origin_;
  int x_ = 0, y_ = 1, z_ = 2;
  double slope_x_ = 0.0, slope_y_ = 0.0;
};

/// Whether an edge passes the positive x axis, which is worked out in the same way from both its faces.
bool passes_axis(const glm::dvec2& a, const glm::dvec2& b) {
  if ((a.y > 0.0) == (b.y > 0.0)) return false;
  const glm::dvec2& low = a.y > 0.0 ? b : a;
  const glm::dvec2& high = a.y > 0.0 ? a : b;
  return low.x * high.y - low.y * high.x > 0.0;
}

bool holds_origin(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (passes_axis(a, b) != passes_axis(b, c)) != passes_axis(c, a);
}

}  // namespace

TriangleTree::TriangleTree(const MeshTopology& topology)
    : topology_(&topology), tree_(boxes_of(topology), 1), wide_(tree_) {
  if (tree_.nodes().empty()) return;
  on_plane_ = kOnPlaneShare * glm::length(glm::dvec3(tree_.nodes()[0].box.size()));
}

template <class Use>
void TriangleTree::each_hit(const Ray& ray, const double& to, Use&& use) const {
  const Shear shear(ray);
  wide_.walk(ray.origin, ray.direction, ray.from, to, [&](uint32_t place) {
    const uint32_t face = tree_.items()[place];
    const auto& corners = topology_->faces[face];
    const glm::dvec3& a = topology_->positions[corners[0]];
    if (!holds_origin(shear(a), shear(topology_->positions[corners[1]]),
                      shear(topology_->positions[corners[2]])))
      return;
    const glm::dvec3& normal = topology_->normals[face];
    const double along = glm::dot(normal, ray.direction);
    if (along == 0.0) return;
    const double t = glm::dot(normal, a - ray.origin) / along;
    if (t >= ray.from && t <= to) use(face, t);
  });
}

int TriangleTree::count_passed(const Ray& ray, const glm::dvec3& target) const {
  int count = 0;
  each_hit(ray, ray.to, [&](uint32_t face, double) {
    const glm::dvec3& corner = topology_->positions[topology_->faces[face][0]];
    if (std::abs(glm::dot(topology_->normals[face], target - corner)) > on_plane_) ++count;
  });
  return count;
}

std::optional<double> TriangleTree::first_hit(const Ray& ray) const {
  std::optional<double> first;
  double to = ray.to;
  each_hit(ray, to, [&](uint32_t, double t) { first = to = t; });
  return first;
}

}  // namespace inkbench
