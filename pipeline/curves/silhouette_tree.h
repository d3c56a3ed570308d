// SPDX-License-Identifier: MIT
// Silhouettes without looking at every edge. In: items with the normals and places that decide which way they
// face. Out, for an eye: the items that may face both ways. A hierarchy of normal cones, as in Johnson and
// Cohen, "Spatialized normal cone hierarchies", 2001.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "pipeline/curves/box_tree.h"
#include "pipeline/lines/topology.h"
#include "pipeline/lines/viewpoint.h"

namespace inkbench {

/// What of an item is asked which way it faces: each normal, at any point of the box.
struct FacingItem {
  Box box;
  std::span<const glm::dvec3> normals;  ///< Of unit length; those that are 0 face nowhere.
};

class SilhouetteTree {
 public:
  SilhouetteTree() = default;
  explicit SilhouetteTree(std::span<const FacingItem> items);

  /// Calls `use(item)` for a superset of the items with dot(normal, eye - point) of both signs, or 0, for
  /// some normals and points of theirs.
  template <class Use>
  void each_candidate(const Viewpoint& eye, Use&& use) const {
    tree_.walk([&](uint32_t node) { return may_turn(node, eye); }, use);
  }

  /// How many nodes are looked at.
  size_t visited(const Viewpoint& eye) const;

 private:
  /// All normals are within the angle of the axis; a cone of all directions has the cosine -1.
  struct Cone {
    glm::dvec3 axis{0.0};
    double cosine = 1.0, sine = 0.0;
  };
  bool may_turn(uint32_t node, const Viewpoint& eye) const;

  BoxTree tree_;
  std::vector<Cone> cones_;  ///< By node.
};

/// A tree over a mesh's edges that have two faces or more, and the edges of its items.
struct EdgeSilhouettes {
  explicit EdgeSilhouettes(const MeshTopology& topology);
  /// The same edges as `silhouette_edges`, in order.
  std::vector<uint32_t> find(const MeshTopology& topology, const Viewpoint& eye, bool mirrored) const;

  SilhouetteTree tree;
  std::vector<uint32_t> edges;
};

}  // namespace inkbench
