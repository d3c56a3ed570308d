// SPDX-License-Identifier: MIT
#include "pipeline/mesh/orientation.h"

#include <glm/geometric.hpp>

namespace inkbench {
namespace {

/// What lies across an edge of two triangles.
struct Neighbour {
  uint32_t triangle = kNoPoint;
  bool is_against = false;  ///< The two run along the edge in one sense.
};

/// One part, its triangles and what they say, signs as after `is_turned` of the first sweep.
struct Part {
  std::vector<uint32_t> triangles;
  bool is_closed = true;
  bool is_one_sided = false;
  double volume = 0.0;     ///< Six times, faces outwards positive.
  double kept_area = 0.0;  ///< Of triangles as they are, less that of those turned.
  double votes = 0.0;
  size_t turned = 0;
};

class Turner {
 public:
  Turner(const std::vector<glm::vec3>& points, const std::vector<Triangle>& triangles,
         const std::vector<EdgeUse>& edges, const std::vector<double>& votes, bool outwards)
      : points_(points), triangles_(triangles), votes_(votes), outwards_(outwards) {
    neighbours_.resize(triangles.size() * 3);
    for_each_edge(edges, [&](size_t begin, size_t end) {
      if (end - begin != 2) return;
      const EdgeUse &a = edges[begin], &b = edges[begin + 1];
      const bool is_against = a.is_rising == b.is_rising;
      neighbours_[a.corner] = {b.triangle(), is_against};
      neighbours_[b.corner] = {a.triangle(), is_against};
    });
  }

  Orientation run() {
    result_.is_turned.assign(triangles_.size(), false);
    seen_.assign(triangles_.size(), false);
    for (uint32_t first = 0; first < triangles_.size(); ++first) {
      if (!seen_[first]) settle(find_part(first));
    }
    if (result_.mended + result_.turned_to_normals + result_.turned_outwards == 0) result_.is_turned.clear();
    return std::move(result_);
  }

 private:
  /// Turns what lies against the first triangle, and adds up.
  Part find_part(uint32_t first) {
    Part part;
    part.triangles.push_back(first);
    seen_[first] = true;
    for (size_t i = 0; i < part.triangles.size(); ++i) {
      const uint32_t face = part.triangles[i];
      add(face, part);
      for (uint32_t corner = 3 * face; corner < 3 * face + 3; ++corner) {
        const auto [other, is_against] = neighbours_[corner];
        if (other == kNoPoint) {
          part.is_closed = false;
          continue;
        }
        const bool turned = result_.is_turned[face] != is_against;
        if (seen_[other]) {
          part.is_one_sided = part.is_one_sided || result_.is_turned[other] != turned;
        } else {
          seen_[other] = true;
          result_.is_turned[other] = turned;
          part.triangles.push_back(other);
        }
      }
    }
    return part;
  }

  void add(uint32_t face, Part& part) const {
    const Triangle& t = triangles_[face];
    const glm::dvec3 a = points_[t[0]], b = points_[t[1]], c = points_[t[2]];
    const bool is_turned = result_.is_turned[face];
    const double sign = is_turned ? -1.0 : 1.0;
    part.volume += sign * glm::dot(a, glm::cross(b, c));
    part.kept_area += sign * glm::length(glm::cross(b - a, c - a));
    if (!votes_.empty()) part.votes += sign * votes_[face];
    part.turned += is_turned ? 1 : 0;
  }

  void settle(const Part& part) {
    if (part.is_one_sided) {
      ++result_.one_sided_parts;
      for (const uint32_t face : part.triangles) result_.is_turned[face] = false;
      return;
    }
    const bool is_mixed = part.turned > 0 && part.turned < part.triangles.size();
    const double sense = part.votes != 0.0 ? part.votes : part.is_closed ? part.volume : part.kept_area;
    bool over = (is_mixed || part.votes != 0.0) && sense < 0.0;
    const bool faces_inwards = part.is_closed && (part.volume < 0.0) != over && part.volume != 0.0;
    const bool to_outside = outwards_ && faces_inwards;
    if (to_outside) over = !over;
    if (over) {
      for (const uint32_t face : part.triangles) result_.is_turned[face] = !result_.is_turned[face];
    }
    if (faces_inwards && !to_outside) ++result_.inside_out_parts;
    const size_t turned = over ? part.triangles.size() - part.turned : part.turned;
    (is_mixed ? result_.mended : to_outside ? result_.turned_outwards : result_.turned_to_normals) += turned;
  }

  const std::vector<glm::vec3>& points_;
  const std::vector<Triangle>& triangles_;
  const std::vector<double>& votes_;
  bool outwards_;
  std::vector<Neighbour> neighbours_;
  std::vector<bool> seen_;
  Orientation result_;
};

}  // namespace

Orientation find_orientation(const std::vector<glm::vec3>& points, const std::vector<Triangle>& triangles,
                             const std::vector<EdgeUse>& edges, const std::vector<double>& votes,
                             bool outwards) {
  return Turner(points, triangles, edges, votes, outwards).run();
}

}  // namespace inkbench
