// SPDX-License-Identifier: MIT
#include "pipeline/mesh/polygon_soup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/normals.h"
#include "pipeline/mesh/triangulate.h"

namespace inkbench {
namespace {

using Triangle = std::array<uint32_t, 3>;

constexpr uint32_t kUnused = std::numeric_limits<uint32_t>::max();

struct Defects {
  uint64_t out_of_range = 0;
  int64_t worst_index = 0;  ///< The offending index farthest from zero.
  uint64_t not_finite = 0;
  uint64_t zero_area = 0;
};

std::string counted(uint64_t count, const std::string& one, const std::string& many) {
  return with_commas(static_cast<long long>(count)) + " " + (count == 1 ? one : many);
}

std::string faces(uint64_t count) {
  return counted(count, "face", "faces");
}

bool indices_in_range(std::span<const int32_t> polygon, size_t points, Defects& defects) {
  bool good = true;
  for (const int64_t index : polygon) {
    if (index >= 0 && index < static_cast<int64_t>(points)) continue;
    good = false;
    if (std::llabs(index) >= std::llabs(defects.worst_index)) defects.worst_index = index;
  }
  return good;
}

std::vector<Triangle> drawable_triangles(const PolygonSoup& soup, Defects& defects) {
  std::vector<Triangle> triangles;
  triangles.reserve(soup.corner_counts.size());
  size_t begin = 0;
  for (const uint32_t count : soup.corner_counts) {
    assert(begin + count <= soup.corners.size());
    const std::span<const int32_t> polygon(soup.corners.data() + begin, count);
    begin += count;
    if (!indices_in_range(polygon, soup.points.size(), defects)) {
      ++defects.out_of_range;
    } else if (!std::ranges::all_of(polygon, [&](int32_t index) { return is_finite(soup.points[index]); })) {
      ++defects.not_finite;
    } else if (!triangulate(soup.points, polygon, triangles)) {
      ++defects.zero_area;
    }
  }
  return triangles;
}

/// Keeps the used points in their order and renumbers the triangles; returns each kept vertex's old index.
std::vector<uint32_t> compact(const PolygonSoup& soup, Mesh& mesh) {
  std::vector<uint32_t> renumbered(soup.points.size(), kUnused);
  for (const Triangle& triangle : mesh.triangles) {
    for (const uint32_t vertex : triangle) renumbered[vertex] = 0;
  }
  std::vector<uint32_t> kept;
  for (uint32_t old = 0; old < renumbered.size(); ++old) {
    if (renumbered[old] == kUnused) continue;
    renumbered[old] = static_cast<uint32_t>(kept.size());
    kept.push_back(old);
  }
  for (Triangle& triangle : mesh.triangles) {
    for (uint32_t& vertex : triangle) vertex = renumbered[vertex];
  }
  mesh.positions.reserve(kept.size());
  for (const uint32_t old : kept) mesh.positions.push_back(soup.points[old]);
  return kept;
}

struct OddEdges {
  uint64_t crowded = 0;   ///< Of more than two triangles.
  uint64_t opposite = 0;  ///< Of two triangles of which one is turned over.
};

OddEdges count_odd_edges(const Mesh& mesh) {
  std::vector<uint64_t>
      edges;  // 31 bits for each end, since files number points with 32 signed ones; last the sense
  edges.reserve(mesh.triangles.size() * 3);
  for (const Triangle& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      const uint64_t is_rising = triangle[i] == low ? 1 : 0;
      edges.push_back(static_cast<uint64_t>(low) << 33 | static_cast<uint64_t>(high) << 1 | is_rising);
    }
  }
  std::ranges::sort(edges);
  OddEdges odd;
  for (size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end] >> 1 == edges[begin] >> 1) ++end;
    if (end - begin > 2) ++odd.crowded;
    if (end - begin == 2 && edges[begin] == edges[begin + 1]) ++odd.opposite;
  }
  return odd;
}

void note_odd_edges(const OddEdges& odd, std::vector<std::string>& notes) {
  if (odd.crowded > 0) {
    notes.push_back(fmt::format("Kept {}, shared by more than two faces.",
                                counted(odd.crowded, "non-manifold edge", "non-manifold edges")));
  }
  if (odd.opposite > 0) {
    notes.push_back(
        fmt::format("Kept {} between faces turned opposite ways: a line at each, and no decimation there.",
                    counted(odd.opposite, "edge", "edges")));
  }
}

/// Takes the file's normals if it has any and each vertex has one of usable length; else says in one sentence
/// why not. A file without normals is no defect and needs no word.
std::string take_normals(const PolygonSoup& soup, std::span<const uint32_t> kept, Mesh& mesh) {
  if (soup.normals.empty()) return "";
  if (soup.split_normals > 0) {
    return fmt::format("Normals are computed from the faces: the file gives {} several different ones.",
                       counted(soup.split_normals, "vertex", "vertices"));
  }
  assert(soup.normals.size() == soup.points.size());
  uint64_t unusable = 0;
  mesh.normals.reserve(kept.size());
  for (const uint32_t old : kept) {
    const glm::dvec3 normal = soup.normals[old];
    const double length = glm::length(normal);
    if (!std::isfinite(length) || !(length > 0.0)) ++unusable;
    mesh.normals.emplace_back(normal / length);
  }
  if (unusable == 0) return "";
  return fmt::format("Normals are computed from the faces: the file has no usable one for {}.",
                     counted(unusable, "vertex", "vertices"));
}

void note_dropped_faces(const Defects& defects, size_t points, std::vector<std::string>& notes) {
  if (defects.out_of_range > 0) {
    notes.push_back(
        fmt::format("Dropped {} naming a vertex outside the file's {} (such as index {}, counted from 0).",
                    faces(defects.out_of_range), with_commas(static_cast<long long>(points)),
                    with_commas(defects.worst_index)));
  }
  if (defects.not_finite > 0) {
    notes.push_back(fmt::format("Dropped {} with a corner at NaN or infinity.", faces(defects.not_finite)));
  }
  if (defects.zero_area > 0)
    notes.push_back(fmt::format("Dropped {} without area.", faces(defects.zero_area)));
}

}  // namespace

Mesh mesh_from_soup(const PolygonSoup& soup, const std::string& where) {
  if (soup.corner_counts.empty() && soup.empty_polygons == 0) {
    throw input_error(where,
                      fmt::format("holds {} but no faces", counted(soup.points.size(), "point", "points")),
                      "a mesh needs triangles or polygons");
  }
  Defects defects;
  defects.zero_area = soup.empty_polygons;
  Mesh mesh;
  mesh.triangles = drawable_triangles(soup, defects);
  note_dropped_faces(defects, soup.points.size(), mesh.notes);
  if (mesh.triangles.empty()) {
    throw input_error(where, "no face can be drawn: " + join(mesh.notes, " "),
                      "a mesh needs triangles or polygons");
  }
  if (soup.merged_points > 0) {
    mesh.notes.push_back(fmt::format("Merged {} into others that rounding alone kept apart.",
                                     counted(soup.merged_points, "vertex", "vertices")));
  }
  const std::vector<uint32_t> kept = compact(soup, mesh);
  if (const size_t isolated = soup.points.size() - kept.size(); isolated > 0) {
    mesh.notes.push_back(fmt::format("Removed {} that no drawn face uses.",
                                     counted(isolated, "isolated vertex", "isolated vertices")));
  }
  note_odd_edges(count_odd_edges(mesh), mesh.notes);
  const std::string why_unusable = take_normals(soup, kept, mesh);
  if (!why_unusable.empty()) mesh.notes.push_back(why_unusable);
  if (soup.normals.empty() || !why_unusable.empty()) smooth_normals(mesh);
  return mesh;
}

}  // namespace inkbench
