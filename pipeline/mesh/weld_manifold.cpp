// SPDX-License-Identifier: MIT
#include "pipeline/mesh/weld_manifold.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "pipeline/mesh/weld.h"

namespace inkbench {
namespace {

using Triangle = std::array<uint32_t, 3>;
constexpr uint32_t kLeftOut = ManifoldPieces::kLeftOut;
constexpr Triangle kNoTriangle{kLeftOut, kLeftOut, kLeftOut};

bool is_left_out(const Triangle& triangle) {
  return triangle[0] == kLeftOut;
}

/// A directed edge of a triangle under the name of its two ends, lower first. `corner` is where it starts.
struct Edge {
  uint64_t ends = 0;
  uint32_t corner = 0;  ///< 3 x triangle + which.
  bool is_rising = false;

  auto operator<=>(const Edge&) const = default;
};

uint32_t next_corner(uint32_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

std::vector<Edge> sorted_edges(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(triangles.size() * 3);
  for (uint32_t face = 0; face < triangles.size(); ++face) {
    const Triangle& t = triangles[face];
    if (is_left_out(t)) continue;
    for (uint32_t i = 0; i < 3; ++i) {
      const uint32_t from = t[i];
      const uint32_t to = t[(i + 1) % 3];
      const auto [low, high] = std::minmax(from, to);
      edges.push_back({static_cast<uint64_t>(low) << 32 | high, 3 * face + i, from < to});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Calls `visit(begin, end)` for each undirected edge's range.
template <class Visit>
void for_each_edge(const std::vector<Edge>& edges, Visit&& visit) {
  for (size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].ends == edges[begin].ends) ++end;
    visit(begin, end);
  }
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

/// A forest over 0, 1, 2, ...; each tree's root is its smallest member.
class Forest {
 public:
  explicit Forest(size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

  uint32_t root(uint32_t member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  void join(uint32_t a, uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<uint32_t> parent_;
};

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
  const std::vector<Edge> edges = sorted_edges(doubled);
  for_each_edge(edges, [&](size_t begin, size_t end) {
    if (end - begin != 4) return;
    const Edge& first = edges[begin];
    for (size_t i = begin + 1; i < end; ++i) {
      const uint32_t other = edges[i].corner / 3;
      if (edges[i].is_rising == first.is_rising || other == back[first.corner / 3]) continue;
      sides.join(first.corner / 3, other);
      sides.join(back[first.corner / 3], back[other]);
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
Fans join_fans(const std::vector<Triangle>& triangles) {
  Fans fans{Forest(triangles.size() * 3)};
  const std::vector<Edge> edges = sorted_edges(triangles);
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
std::vector<uint32_t> crowded_triangles(const std::vector<Triangle>& corners) {
  const std::vector<Edge> edges = sorted_edges(corners);
  std::vector<uint32_t> crowded;
  for_each_edge(edges, [&](size_t begin, size_t end) {
    bool seen[2] = {false, false};
    for (size_t i = begin; i < end; ++i) {
      if (std::exchange(seen[edges[i].is_rising ? 1 : 0], true)) crowded.push_back(edges[i].corner / 3);
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
    Fans fans = join_fans(triangles);
    number_points(mesh, triangles, fans, pieces);
    const std::vector<uint32_t> crowded =
        fans.has_cut_edges ? crowded_triangles(pieces.corners) : std::vector<uint32_t>();
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
