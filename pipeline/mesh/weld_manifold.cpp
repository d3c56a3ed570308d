// SPDX-License-Identifier: MIT
#include "pipeline/mesh/weld_manifold.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "pipeline/mesh/triangle_edges.h"
#include "pipeline/mesh/weld.h"

namespace inkbench {
namespace {

constexpr uint32_t kLeftOut = ManifoldPieces::kLeftOut;
static_assert(kLeftOut == kNoPoint);
constexpr Triangle kNoTriangle{kLeftOut, kLeftOut, kLeftOut};

bool is_left_out(const Triangle& triangle) {
  return triangle[0] == kLeftOut;
}

/// The triangles over welded vertices, those that name one twice left out.
std::vector<Triangle> welded_triangles(const Mesh& mesh, const std::vector<uint32_t>& first) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Triangle welded{first[t[0]], first[t[1]], first[t[2]]};
    const bool repeats = welded[0] == welded[1] || welded[1] == welded[2] || welded[2] == welded[0];
    triangles.push_back(repeats ? kNoTriangle : welded);
  }
  return triangles;
}

struct Twin {
  Triangle corners;  ///< Rising.
  bool is_odd = false;
  uint32_t face = 0;

  auto operator<=>(const Twin&) const = default;
};

Twin twin_of(const Triangle& t, uint32_t face) {
  Triangle corners = t;
  std::sort(corners.begin(), corners.end());
  const bool is_even = (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2;
  return {corners, !is_even, face};
}

/// Leaves out repetitions; returns for each triangle the one with the same corners in the opposite sense, or
/// `kLeftOut`.
std::vector<uint32_t> find_back_sides(std::vector<Triangle>& triangles) {
  std::vector<Twin> twins;
  twins.reserve(triangles.size());
  for (uint32_t face = 0; face < triangles.size(); ++face) {
    if (!is_left_out(triangles[face])) twins.push_back(twin_of(triangles[face], face));
  }
  std::sort(twins.begin(), twins.end());
  std::vector<uint32_t> back(triangles.size(), kLeftOut);
  for (size_t kept = 0, i = 1; i < twins.size(); ++i) {
    if (twins[i].corners != twins[kept].corners) {
      kept = i;
    } else if (twins[i].is_odd == twins[kept].is_odd) {
      triangles[twins[i].face] = kNoTriangle;
    } else {
      back[twins[kept].face] = twins[i].face;
      back[twins[i].face] = twins[kept].face;
      kept = i;
    }
  }
  return back;
}

/// Of triangles that lie back to back, one side gets vertices of its own (raised by `offset`): the one that
/// begins later, taking as a side what hangs together across edges in one sense.
void separate_back_sides(std::vector<Triangle>& triangles, uint32_t offset) {
  const std::vector<uint32_t> back = find_back_sides(triangles);
  std::vector<Triangle> doubled = triangles;
  bool has_any = false;
  for (uint32_t face = 0; face < doubled.size(); ++face) {
    if (back[face] == kLeftOut) doubled[face] = kNoTriangle;
    has_any = has_any || back[face] != kLeftOut;
  }
  if (!has_any) return;
  Forest sides(triangles.size());
  const std::vector<EdgeUse> edges = sorted_edges(doubled, offset);
  for_each_edge(edges, [&](size_t begin, size_t end) {
    if (end - begin != 4) return;
    const EdgeUse& first = edges[begin];
    for (size_t i = begin + 1; i < end; ++i) {
      const uint32_t other = edges[i].triangle();
      if (edges[i].is_rising == first.is_rising || other == back[first.triangle()]) continue;
      sides.join(first.triangle(), other);
      sides.join(back[first.triangle()], back[other]);
    }
  });
  for (uint32_t face = 0; face < triangles.size(); ++face) {
    if (back[face] == kLeftOut || sides.root(face) <= sides.root(back[face])) continue;
    for (uint32_t& corner : triangles[face]) corner += offset;
  }
}

struct Fans {
  Forest corners;  ///< Each tree is one fan.
  bool has_cut_edges = false;
};

/// Corners joined across every edge of two triangles of equal orientation.
Fans join_fans(const std::vector<Triangle>& triangles, size_t point_count) {
  Fans fans{Forest(triangles.size() * 3)};
  const std::vector<EdgeUse> edges = sorted_edges(triangles, point_count);
  for_each_edge(edges, [&](size_t begin, size_t end) {
    if (end - begin == 1) return;
    if (end - begin != 2 || edges[begin].is_rising == edges[begin + 1].is_rising) {
      fans.has_cut_edges = true;
      return;
    }
    fans.corners.join(edges[begin].corner, next_corner(edges[begin + 1].corner));
    fans.corners.join(next_corner(edges[begin].corner), edges[begin + 1].corner);
  });
  return fans;
}

/// Numbers the fans in the order of the triangles.
void number_points(const Mesh& mesh, const std::vector<Triangle>& triangles, Fans& fans,
                   ManifoldPieces& pieces) {
  std::vector<uint32_t> number(triangles.size() * 3, kLeftOut);
  pieces.corners.assign(triangles.size(), kNoTriangle);
  pieces.origin.clear();
  pieces.triangles = 0;
  for (uint32_t face = 0; face < triangles.size(); ++face) {
    if (is_left_out(triangles[face])) continue;
    ++pieces.triangles;
    for (uint32_t i = 0; i < 3; ++i) {
      uint32_t& point = number[fans.corners.root(3 * face + i)];
      if (point == kLeftOut) {
        point = static_cast<uint32_t>(pieces.origin.size());
        pieces.origin.push_back(mesh.triangles[face][i]);
      }
      pieces.corners[face][i] = point;
    }
  }
}

/// Triangles that share a directed edge with an earlier one: where a fan meets itself in one edge, that
/// outlives the cut.
std::vector<uint32_t> crowded_triangles(const std::vector<Triangle>& corners, size_t point_count) {
  const std::vector<EdgeUse> edges = sorted_edges(corners, point_count);
  std::vector<uint32_t> crowded;
  for_each_edge(edges, [&](size_t begin, size_t end) {
    bool seen[2] = {false, false};
    for (size_t i = begin; i < end; ++i) {
      if (std::exchange(seen[edges[i].is_rising ? 1 : 0], true)) crowded.push_back(edges[i].triangle());
    }
  });
  std::sort(crowded.begin(), crowded.end());
  crowded.erase(std::unique(crowded.begin(), crowded.end()), crowded.end());
  return crowded;
}

/// Points whose welded vertex became several, or is one of the `cut` ones.
void mark_cuts(const std::vector<Triangle>& triangles, const std::vector<bool>& cut, ManifoldPieces& pieces) {
  std::vector<uint32_t> first_point(cut.size(), kLeftOut);
  pieces.is_cut.assign(pieces.origin.size(), false);
  for (size_t face = 0; face < triangles.size(); ++face) {
    if (is_left_out(triangles[face])) continue;
    for (int i = 0; i < 3; ++i) {
      uint32_t& first = first_point[triangles[face][i]];
      const uint32_t point = pieces.corners[face][i];
      if (first == kLeftOut) first = point;
      if (first != point || cut[triangles[face][i]]) pieces.is_cut[first] = pieces.is_cut[point] = true;
    }
  }
}

std::vector<uint32_t> rings_of(const std::vector<uint32_t>& first) {
  std::vector<uint32_t> next(first.size());
  std::iota(next.begin(), next.end(), 0U);
  for (uint32_t vertex = 0; vertex < first.size(); ++vertex) {
    if (first[vertex] != vertex) std::swap(next[vertex], next[first[vertex]]);
  }
  return next;
}

}  // namespace

ManifoldPieces cut_to_manifold(const Mesh& mesh) {
  const std::vector<uint32_t> first = first_at_same_position(mesh.positions);
  std::vector<Triangle> triangles = welded_triangles(mesh, first);
  separate_back_sides(triangles, static_cast<uint32_t>(mesh.positions.size()));
  ManifoldPieces pieces;
  pieces.next_equal = rings_of(first);
  std::vector<bool> cut(2 * mesh.positions.size(), false);
  while (true) {
    Fans fans = join_fans(triangles, cut.size());
    number_points(mesh, triangles, fans, pieces);
    const std::vector<uint32_t> crowded = fans.has_cut_edges
                                              ? crowded_triangles(pieces.corners, pieces.origin.size())
                                              : std::vector<uint32_t>();
    // Each such triangle becomes a piece of its own. That may part a fan, hence once more from the start.
    for (const uint32_t face : crowded) {
      for (uint32_t& corner : triangles[face]) {
        cut[corner] = true;
        corner = static_cast<uint32_t>(cut.size());
        cut.push_back(true);
      }
    }
    if (crowded.empty()) break;
  }
  mark_cuts(triangles, cut, pieces);
  return pieces;
}

}  // namespace inkbench
