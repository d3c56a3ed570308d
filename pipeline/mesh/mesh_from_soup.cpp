// SPDX-License-Identifier: MIT
#include "pipeline/mesh/mesh_from_soup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/corner_normals.h"
#include "pipeline/mesh/orientation.h"
#include "pipeline/mesh/soup_points.h"
#include "pipeline/mesh/triangulate.h"

namespace inkbench {
namespace {

std::string faces(uint64_t count) {
  return counted(count, "face", "faces");
}

bool is_finite_point(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Finite and not zero: it has a direction.
bool is_usable(const glm::dvec3& normal) {
  const double length = glm::length(normal);
  return std::isfinite(length) && length > 0.0;
}

/// Triangles between corners of the soup, and what was left out of it.
class SoupTriangles {
 public:
  explicit SoupTriangles(const PolygonSoup& soup) : soup_(soup) {
    triangles_.reserve(soup.corner_counts.size());
    zero_area_ = soup.empty_polygons;
    size_t begin = 0;
    for (uint32_t polygon = 0; polygon < soup.corner_counts.size(); ++polygon) {
      const uint32_t count = soup.corner_counts[polygon];
      assert(begin + count <= soup.corners.size());
      add_polygon(polygon, static_cast<uint32_t>(begin), count);
      begin += count;
    }
  }

  const std::vector<Triangle>& triangles() const { return triangles_; }
  uint32_t group(size_t triangle) const { return soup_.smoothing_groups[polygons_[triangle]]; }

  /// Drops triangles whose corners have come to one place.
  void drop_collapsed(const std::vector<uint32_t>& first) {
    size_t kept = 0;
    for (size_t i = 0; i < triangles_.size(); ++i) {
      const auto place = [&](int corner) { return first[soup_.corners[triangles_[i][corner]]]; };
      if (place(0) == place(1) || place(1) == place(2) || place(2) == place(0)) {
        ++zero_area_;
        continue;
      }
      triangles_[kept] = triangles_[i];
      polygons_[kept++] = polygons_[i];
    }
    triangles_.resize(kept);
    polygons_.resize(kept);
  }

  void turn(const std::vector<bool>& is_turned) {
    for (size_t i = 0; i < is_turned.size(); ++i) {
      if (is_turned[i]) std::swap(triangles_[i][1], triangles_[i][2]);
    }
  }

  void note_defects(std::vector<std::string>& notes) const {
    if (out_of_range_ > 0) {
      notes.push_back(
          fmt::format("Dropped {} naming a vertex outside the file's {} (such as index {}, counted from 0).",
                      faces(out_of_range_), with_commas(static_cast<long long>(soup_.points.size())),
                      with_commas(worst_index_)));
    }
    if (not_finite_ > 0)
      notes.push_back(fmt::format("Dropped {} with a corner at NaN or infinity.", faces(not_finite_)));
    if (zero_area_ > 0) notes.push_back(fmt::format("Dropped {} without area.", faces(zero_area_)));
    if (crossed_ > 0) {
      notes.push_back(fmt::format("{}: what is covered there is a guess.",
                                  counted(crossed_, "polygon crosses itself", "polygons cross themselves")));
    }
  }

 private:
  void add_polygon(uint32_t polygon, uint32_t begin, uint32_t count) {
    const std::span<const int32_t> indices(soup_.corners.data() + begin, count);
    if (!are_in_range(indices)) {
      ++out_of_range_;
      return;
    }
    corners_.clear();
    for (const int32_t index : indices) corners_.push_back(soup_.points[index]);
    if (!std::ranges::all_of(corners_, is_finite_point)) {
      ++not_finite_;
      return;
    }
    const size_t before = triangles_.size();
    const Triangulation result = triangulate(corners_, triangles_);
    zero_area_ += result == Triangulation::no_area ? 1 : 0;
    crossed_ += result == Triangulation::crossed ? 1 : 0;
    for (size_t i = before; i < triangles_.size(); ++i) {
      for (uint32_t& corner : triangles_[i]) corner += begin;
    }
    polygons_.resize(triangles_.size(), polygon);
  }

  bool are_in_range(std::span<const int32_t> polygon) {
    bool good = true;
    for (const int64_t index : polygon) {
      if (index >= 0 && index < static_cast<int64_t>(soup_.points.size())) continue;
      good = false;
      if (std::llabs(index) >= std::llabs(worst_index_)) worst_index_ = index;
    }
    return good;
  }

  const PolygonSoup& soup_;
  std::vector<Triangle> triangles_;  ///< Of corners' numbers in the soup.
  std::vector<uint32_t> polygons_;   ///< For each triangle.
  std::vector<glm::dvec3> corners_;
  uint64_t out_of_range_ = 0, not_finite_ = 0, zero_area_ = 0, crossed_ = 0;
  int64_t worst_index_ = 0;  ///< The offending index farthest from zero.
};

class MeshMaker {
 public:
  MeshMaker(const PolygonSoup& soup, const MeshOptions& options)
      : soup_(soup), options_(options), corners_(soup) {
    mesh_.notes = soup.notes;
  }

  Mesh run(const std::string& where) {
    take_places();
    corners_.note_defects(mesh_.notes);
    if (corners_.triangles().empty()) {
      throw input_error(where, "no face can be drawn: " + join(mesh_.notes, " "),
                        "a mesh needs triangles or polygons");
    }
    number_points();
    edges_ = sorted_edges(mesh_.triangles, mesh_.positions.size());
    orient();
    note_odd_edges();
    find_normals();
    return std::move(mesh_);
  }

 private:
  void take_places() {
    std::vector<bool> used(soup_.points.size(), false);
    for (const Triangle& t : corners_.triangles()) {
      for (const uint32_t corner : t) used[soup_.corners[corner]] = true;
    }
    points_ = take_points(soup_, used);
    mesh_.origin = points_.origin;
    mesh_.unit = points_.unit;
    corners_.drop_collapsed(points_.first);
    isolated_ = static_cast<size_t>(std::ranges::count(used, false));
  }

  /// Keeps the places that triangles use in their order.
  void number_points() {
    std::vector<uint32_t> number(points_.first.size(), kNoPoint);
    for (const Triangle& t : corners_.triangles()) {
      for (const uint32_t corner : t) number[points_.first[soup_.corners[corner]]] = 0;
    }
    for (size_t point = 0; point < number.size(); ++point) {
      if (number[point] == kNoPoint) continue;
      number[point] = static_cast<uint32_t>(mesh_.positions.size());
      mesh_.positions.push_back(points_.places[point]);
    }
    mesh_.triangles.reserve(corners_.triangles().size());
    for (const Triangle& t : corners_.triangles()) {
      Triangle& points = mesh_.triangles.emplace_back();
      for (int i = 0; i < 3; ++i) points[i] = number[points_.first[soup_.corners[t[i]]]];
    }
    if (points_.merged_by_rounding > 0) {
      mesh_.notes.push_back(fmt::format("Merged {} into others that rounding alone kept apart.",
                                        counted(points_.merged_by_rounding, "vertex", "vertices")));
    }
    if (isolated_ > 0) {
      mesh_.notes.push_back(fmt::format("Removed {} that no drawn face uses.",
                                        counted(isolated_, "isolated vertex", "isolated vertices")));
    }
  }

  /// The file's, where it has one that is usable.
  const glm::vec3* file_normal(uint32_t corner) const {
    if (!options_.use_file_normals || soup_.corner_normals.empty()) return nullptr;
    const int64_t index = soup_.corner_normals[corner];
    if (index < 0 || index >= static_cast<int64_t>(soup_.normals.size())) return nullptr;
    return is_usable(soup_.normals[index]) ? &soup_.normals[index] : nullptr;
  }

  glm::dvec3 area_of(size_t triangle) const {
    const Triangle& t = mesh_.triangles[triangle];
    const glm::dvec3 a = mesh_.positions[t[0]];
    return glm::cross(glm::dvec3(mesh_.positions[t[1]]) - a, glm::dvec3(mesh_.positions[t[2]]) - a);
  }

  /// How many of a triangle's corners have normals that agree with it, less those that oppose it.
  int agreement(size_t triangle) const {
    const glm::dvec3 area = area_of(triangle);
    int sum = 0;
    for (const uint32_t corner : corners_.triangles()[triangle]) {
      const glm::vec3* normal = file_normal(corner);
      if (normal == nullptr) continue;
      const double along = glm::dot(area, glm::dvec3(*normal));
      sum += along > 0.0 ? 1 : along < 0.0 ? -1 : 0;
    }
    return sum;
  }

  std::vector<double> votes() const {
    if (!options_.use_file_normals || soup_.corner_normals.empty()) return {};
    std::vector<double> votes(mesh_.triangles.size(), 0.0);
    for (size_t i = 0; i < votes.size(); ++i) {
      const int sum = agreement(i);
      if (std::abs(sum) == 3) votes[i] = glm::length(area_of(i)) * (sum > 0 ? 1.0 : -1.0);
    }
    return votes;
  }

  void orient() {
    const Orientation found =
        find_orientation(mesh_.positions, mesh_.triangles, edges_, votes(), options_.outwards);
    note_orientation(found);
    if (found.is_turned.empty()) return;
    corners_.turn(found.is_turned);
    for (size_t i = 0; i < found.is_turned.size(); ++i) {
      if (found.is_turned[i]) std::swap(mesh_.triangles[i][1], mesh_.triangles[i][2]);
    }
    edges_ = sorted_edges(mesh_.triangles, mesh_.positions.size());
    is_turned_ = found.is_turned;
  }

  void note_orientation(const Orientation& found) {
    const auto note = [&](size_t count, const char* text) {
      if (count > 0) mesh_.notes.push_back(fmt::format(fmt::runtime(text), faces(count)));
    };
    note(found.mended, "Turned {} over that lay against the neighbours.");
    note(found.turned_to_normals, "Turned {} over to the side that the file's normals show.");
    note(found.turned_outwards, "Turned {} of closed parts outwards.");
    if (found.inside_out_parts > 0) {
      mesh_.notes.push_back(
          fmt::format("{} inwards: a cavity, or a mesh that is inside out, which "
                      "'orient = \"outward\"' turns.",
                      counted(found.inside_out_parts, "closed part faces", "closed parts face")));
    }
  }

  void note_odd_edges() {
    size_t crowded = 0, opposite = 0;
    for_each_edge(edges_, [&](size_t begin, size_t end) {
      crowded += end - begin > 2 ? 1 : 0;
      opposite += end - begin == 2 && edges_[begin].is_rising == edges_[begin + 1].is_rising ? 1 : 0;
    });
    if (crowded > 0) {
      mesh_.notes.push_back(fmt::format("Kept {}, shared by more than two faces.",
                                        counted(crowded, "non-manifold edge", "non-manifold edges")));
    }
    if (opposite > 0) {
      mesh_.notes.push_back(fmt::format(
          "Kept {} between faces turned opposite ways, on a surface with one side: a line at each, "
          "and no decimation there.",
          counted(opposite, "edge", "edges")));
    }
  }

  SmoothEdges smooth_edges() {
    SmoothEdges smooth{options_.smooth_below_deg, {}};
    if (!options_.use_file_normals) return smooth;
    if (soup_.is_flat && soup_.corner_normals.empty()) smooth.below_deg = 0.0;
    if (soup_.smoothing_groups.empty()) return smooth;
    for (size_t i = 0; i < mesh_.triangles.size(); ++i) groups_.push_back(corners_.group(i));
    smooth.groups = groups_;
    return smooth;
  }

  void find_normals() {
    std::vector<glm::vec3> normals(mesh_.triangles.size() * 3);
    const auto given_at = [&](size_t i) { return file_normal(corners_.triangles()[i / 3][i % 3]); };
    size_t given = 0;
    for (size_t i = 0; i < normals.size(); ++i) given += given_at(i) != nullptr ? 1 : 0;
    if (given < normals.size())
      normals = corner_normals(mesh_.positions, mesh_.triangles, edges_, smooth_edges());
    for (size_t i = 0; i < normals.size(); ++i) {
      const glm::vec3* normal = given_at(i);
      if (normal == nullptr) continue;
      const glm::dvec3 direction = glm::normalize(glm::dvec3(*normal));
      // Those of a face that was turned over turn with it, where they were made from it.
      const bool opposes = !is_turned_.empty() && is_turned_[i / 3] && agreement(i / 3) == -3;
      normals[i] = glm::vec3(opposes ? -direction : direction);
    }
    mesh_.has_given_normals = given == normals.size();
    if (given > 0 && given < normals.size()) {
      mesh_.notes.push_back(
          fmt::format("Computed the normals of {} for which the file has none that is usable.",
                      counted(normals.size() - given, "corner", "corners")));
    }
    split_vertices(mesh_, normals, file_order());
  }

  /// Vertices stand where the file has their points, so that what is written reads back in its order.
  std::vector<uint32_t> file_order() const {
    std::vector<uint32_t> order;
    order.reserve(corners_.triangles().size() * 3);
    for (const Triangle& t : corners_.triangles()) {
      for (const uint32_t corner : t) order.push_back(static_cast<uint32_t>(soup_.corners[corner]));
    }
    return order;
  }

  const PolygonSoup& soup_;
  const MeshOptions& options_;
  SoupTriangles corners_;
  SoupPoints points_;
  size_t isolated_ = 0;
  std::vector<EdgeUse> edges_;
  std::vector<bool> is_turned_;
  std::vector<uint32_t> groups_;
  Mesh mesh_;
};

}  // namespace

Mesh mesh_from_soup(const PolygonSoup& soup, const std::string& where, const MeshOptions& options) {
  if (soup.corner_counts.empty() && soup.empty_polygons == 0) {
    throw input_error(where,
                      fmt::format("holds {} but no faces", counted(soup.points.size(), "point", "points")),
                      "a mesh needs triangles or polygons");
  }
  return MeshMaker(soup, options).run(where);
}

}  // namespace inkbench
