// SPDX-License-Identifier: MIT
// Rays against a mesh. In: its topology. Out: how many faces lie on a ray, and the first of them. Whatever a
// ray meets of a closed mesh it meets an even number of times, also where it runs through edges and vertices.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "pipeline/curves/box_tree.h"
#include "pipeline/curves/wide_tree.h"
#include "pipeline/lines/topology.h"

namespace inkbench {

/// Points origin + t direction, with t between `from` and `to`.
struct Ray {
  glm::dvec3 origin{0.0}, direction{0.0};
  double from = 0.0, to = 0.0;

  glm::dvec3 at(double t) const { return origin + t * direction; }
};

class TriangleTree {
 public:
  /// `topology` must outlive it.
  explicit TriangleTree(const MeshTopology& topology);

  const BoxTree& boxes() const { return tree_; }
  const MeshTopology& topology() const { return *topology_; }
  /// Nearer than this to the plane of a face a point lies on it, in the mesh's units: twice a millionth of
  /// the bounding box's diagonal, what coordinates from files are worth.
  double on_plane() const { return on_plane_; }

  /// Faces that the ray passes, without those whose plane goes through `target`: where a line lies on them,
  /// they do not cover it.
  int count_passed(const Ray& ray, const glm::dvec3& target) const;

  /// How far along the ray it first meets a face.
  std::optional<double> first_hit(const Ray& ray) const;

 private:
  template <class Use>
  void each_hit(const Ray& ray, const double& to, Use&& use) const;

  const MeshTopology* topology_;
  BoxTree tree_;
  WideTree wide_;
  double on_plane_ = 0.0;
};

}  // namespace inkbench
