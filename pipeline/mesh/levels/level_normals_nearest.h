// SPDX-License-Identifier: MIT
// The normal of a surface at the point nearest to any given one. In: the full mesh. Out: what a game artist
// bakes onto its levels.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "pipeline/mesh/mesh.h"

namespace inkbench {

/// A mesh's triangles in a tree of boxes. The mesh must outlive it.
class NearestNormals {
 public:
  /// Sorts the triangles: F log F. The mesh has at least one.
  explicit NearestNormals(const Mesh& surface);

  /// The vertex normals interpolated at the surface's point nearest to `point`, unit length. Where several
  /// triangles are equally near (an edge, a corner), the one whose normal agrees best with `towards`.
  glm::vec3 at(const glm::vec3& point, const glm::vec3& towards) const;

 private:
  struct Node {
    glm::vec3 low{0.0F};
    uint32_t first =
        0;  ///< Of a leaf, its first place in `order_`; else the second child, the first being next.
    glm::vec3 high{0.0F};
    uint32_t count = 0;  ///< Triangles of a leaf; 0 in the others.
  };
  struct Search;

  void build(uint32_t begin, uint32_t end, const std::vector<glm::vec3>& middles);
  void fit(Node& node, uint32_t begin, uint32_t end) const;
  void visit_leaf(const Node& node, Search& search) const;

  const Mesh& surface_;
  std::vector<uint32_t> order_;
  std::vector<Node> nodes_;
  double slack_ = 0.0;  ///< Squared distances this near are equal.
};

}  // namespace inkbench
