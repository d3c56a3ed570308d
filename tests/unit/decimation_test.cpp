// SPDX-License-Identifier: MIT
// What the decimation promises at every level, on the rabbit, on built-in shapes and on defective meshes.
#include "pipeline/mesh/levels/decimation.h"
#include "pipeline/mesh/normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "pipeline/mesh/closed.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/shapes/primitives.h"

namespace inkbench {
namespace {

using Triangle = std::array<uint32_t, 3>;

const Mesh& rabbit() {
  static const Mesh mesh = load_mesh_file(find_rabbit(), {.smooth_below_deg = 180.0});
  return mesh;
}

const CollapseRecord& rabbit_record() {
  static const CollapseRecord record = record_collapses(rabbit());
  return record;
}

/// Face counts from all down to about a hundred, evenly spaced in their logarithm.
std::vector<size_t> ladder(size_t faces, int levels) {
  std::vector<size_t> counts;
  for (int i = 0; i < levels; ++i) {
    counts.push_back(static_cast<size_t>(std::lround(
        static_cast<double>(faces) * std::pow(100.0 / static_cast<double>(faces), i / (levels - 1.0)))));
  }
  return counts;
}

glm::dvec3 area_normal(const Mesh& mesh, const Triangle& t) {
  const glm::dvec3 a = mesh.positions[t[0]];
  return 0.5 * glm::cross(glm::dvec3(mesh.positions[t[1]]) - a, glm::dvec3(mesh.positions[t[2]]) - a);
}

Mesh joined(Mesh a, const Mesh& b, const glm::vec3& offset) {
  const auto base = static_cast<uint32_t>(a.positions.size());
  for (const glm::vec3& p : b.positions) a.positions.push_back(p + offset);
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  return a;
}

/// Each triangle from its smallest corner on, all sorted: equal for equal sets of triangles.
std::vector<Triangle> canonical(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) std::rotate(t.begin(), std::ranges::min_element(t), t.end());
  std::ranges::sort(triangles);
  return triangles;
}

/// The cosine of the largest turn that any collapse gives a face, and how many faces each collapse really
/// takes away, by carrying the collapses out one after the other.
struct Replay {
  double smallest_cosine = 1.0;
  bool counts_hold = true;
};

Replay replay_all(const Mesh& mesh, const CollapseRecord& record) {
  Replay replay;
  std::vector<Triangle> faces = record.corners;
  std::vector<std::vector<uint32_t>> around(record.origin.size());
  for (uint32_t face = 0; face < faces.size(); ++face) {
    if (faces[face][0] == CollapseRecord::kLeftOut) continue;
    for (const uint32_t point : faces[face]) around[point].push_back(face);
  }
  const auto normal = [&](const Triangle& t) {
    return area_normal(mesh, {record.origin[t[0]], record.origin[t[1]], record.origin[t[2]]});
  };
  for (size_t i = 0; i < record.collapses.size(); ++i) {
    const auto [removed, kept] = record.collapses[i];
    uint32_t vanished = 0;
    for (const uint32_t face : around[removed]) {
      Triangle& t = faces[face];
      if (std::ranges::count(t, removed) == 0) continue;  // vanished before
      if (std::ranges::count(t, kept) > 0) {
        t = {CollapseRecord::kLeftOut, CollapseRecord::kLeftOut, CollapseRecord::kLeftOut};
        ++vanished;
        continue;
      }
      const glm::dvec3 before = normal(t);
      std::ranges::replace(t, removed, kept);
      const glm::dvec3 after = normal(t);
      if (glm::length(before) > 0.0) {
        replay.smallest_cosine = std::min(
            replay.smallest_cosine, glm::dot(before, after) / (glm::length(before) * glm::length(after)));
      }
      around[kept].push_back(face);
    }
    replay.counts_hold = replay.counts_hold && record.faces[i] - vanished == record.faces[i + 1];
  }
  return replay;
}

TEST(Decimation, rabbit_levels_have_the_asked_count_or_one_or_two_less) {
  for (const size_t asked : ladder(rabbit().triangles.size(), 12)) {
    const size_t reached = mesh_at_level(rabbit(), rabbit_record(), asked).triangles.size();
    EXPECT_LE(reached, asked);
    EXPECT_GE(reached + 2, asked);
  }
}

TEST(Decimation, rabbit_stays_closed_at_every_level) {
  for (const size_t asked : ladder(rabbit().triangles.size(), 12))
    EXPECT_TRUE(is_closed_outwards(mesh_at_level(rabbit(), rabbit_record(), asked))) << asked;
}

TEST(Decimation, no_collapse_turns_a_face_beyond_the_limit) {
  EXPECT_GT(replay_all(rabbit(), rabbit_record()).smallest_cosine, kMaxTurnCosine - 1e-3);
  for (const Mesh& mesh : {make_torus(24, 0.35F), make_box(8), make_rounded_box(6, 0.2F), make_plane(16)})
    EXPECT_GT(replay_all(mesh, record_collapses(mesh)).smallest_cosine, kMaxTurnCosine - 1e-3);
}

TEST(Decimation, the_recorded_counts_are_those_of_the_replay) {
  EXPECT_TRUE(replay_all(rabbit(), rabbit_record()).counts_hold);
  const Mesh plane = make_plane(16);
  EXPECT_TRUE(replay_all(plane, record_collapses(plane)).counts_hold);
}

TEST(Decimation, faces_of_convex_shapes_look_outwards_at_every_level) {
  for (const Mesh& mesh : {make_sphere(24), make_box(8), make_rounded_box(6, 0.2F)}) {
    const CollapseRecord record = record_collapses(mesh);
    for (const size_t asked : ladder(mesh.triangles.size(), 8)) {
      const Mesh level = mesh_at_level(mesh, record, asked);
      for (const Triangle& t : level.triangles) {
        const glm::dvec3 middle = (glm::dvec3(level.positions[t[0]]) + glm::dvec3(level.positions[t[1]]) +
                                   glm::dvec3(level.positions[t[2]]));
        ASSERT_GT(glm::dot(area_normal(level, t), middle), 0.0) << asked;
      }
    }
  }
}

TEST(Decimation, no_two_neighbours_of_a_rabbit_level_lie_folded_on_each_other) {
  for (const size_t asked : ladder(rabbit().triangles.size(), 12)) {
    if (asked == rabbit().triangles.size()) continue;  // the rabbit itself has four, where it was mended
    const Mesh level = mesh_at_level(rabbit(), rabbit_record(), asked);
    std::map<std::pair<uint32_t, uint32_t>, glm::dvec3> sides;
    for (const Triangle& t : level.triangles) {
      for (int i = 0; i < 3; ++i) sides[{t[i], t[(i + 1) % 3]}] = glm::normalize(area_normal(level, t));
    }
    const auto folds = std::ranges::count_if(sides, [&](const auto& side) {
      return glm::dot(side.second, sides[{side.first.second, side.first.first}]) < -0.866;
    });
    EXPECT_EQ(folds, 0) << asked;
  }
}

TEST(Decimation, levels_keep_original_positions_and_normals) {
  const Mesh level = mesh_at_level(rabbit(), rabbit_record(), 1000);
  const auto less = [](const glm::vec3& a, const glm::vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::map<glm::vec3, glm::vec3, decltype(less)> originals(less);
  for (size_t i = 0; i < rabbit().positions.size(); ++i)
    originals[rabbit().positions[i]] = rabbit().normals[i];
  for (size_t i = 0; i < level.positions.size(); ++i) {
    ASSERT_TRUE(originals.contains(level.positions[i]));
    EXPECT_EQ(originals[level.positions[i]], level.normals[i]);
  }
}

TEST(Decimation, a_box_keeps_its_sharp_edges) {
  const Mesh box = make_box(8);
  const CollapseRecord record = record_collapses(box);
  EXPECT_EQ(record.faces.front(), box.triangles.size()) << "its sides are welded, nothing is left out";
  const Mesh level = mesh_at_level(box, record, 12);
  EXPECT_EQ(level.triangles.size(), 12U);
  EXPECT_TRUE(is_closed_outwards(level));
  EXPECT_EQ(level.positions.size(), 24U) << "four vertices for each side";
  for (const Triangle& t : level.triangles) {
    for (const uint32_t vertex : t)
      EXPECT_GT(glm::dot(glm::normalize(area_normal(level, t)), glm::dvec3(level.normals[vertex])), 0.999);
  }
}

TEST(Decimation, a_plane_keeps_its_outline) {
  const Mesh plane = make_plane(32);
  const CollapseRecord record = record_collapses(plane);
  for (const size_t asked : {1500, 500, 100, 10, 2}) {
    const Mesh level = mesh_at_level(plane, record, static_cast<size_t>(asked));
    EXPECT_LE(level.triangles.size(), static_cast<size_t>(asked));
    double area = 0.0;
    for (const Triangle& t : level.triangles) {
      area += glm::length(area_normal(level, t));
      EXPECT_GT(area_normal(level, t).y, 0.0);
    }
    EXPECT_NEAR(area, 1.0, 1e-9);
  }
}

/// The directed edges without an opposite, as pairs of positions.
std::vector<std::pair<glm::dvec3, glm::dvec3>> boundary_of(const Mesh& mesh) {
  std::set<std::pair<uint32_t, uint32_t>> edges;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) edges.emplace(t[i], t[(i + 1) % 3]);
  }
  std::vector<std::pair<glm::dvec3, glm::dvec3>> boundary;
  for (const auto& [from, to] : edges) {
    if (!edges.contains({to, from})) boundary.emplace_back(mesh.positions[from], mesh.positions[to]);
  }
  return boundary;
}

double distance_to_edge(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::length(p - a - t * (b - a));
}

TEST(Decimation, a_curved_boundary_stays_within_its_shift_down_to_the_minimum) {
  Mesh bowl = make_sphere(24);
  std::erase_if(bowl.triangles, [&](const Triangle& t) {
    return std::ranges::any_of(t, [&](uint32_t vertex) { return bowl.positions[vertex].y > 0.4F; });
  });
  const auto before = boundary_of(bowl);
  ASSERT_GT(before.size(), 40U);
  const CollapseRecord record = record_collapses(bowl);
  const auto after = boundary_of(mesh_at_level(bowl, record, 1));
  EXPECT_LT(after.size(), before.size() / 2) << "it is simplified";
  const Bounds bounds = bounds_of(bowl);
  const double limit = kBoundaryShift * glm::length(glm::dvec3(bounds.high) - glm::dvec3(bounds.low));
  for (const auto& [point, next] : before) {
    double nearest = 1.0;
    for (const auto& [a, b] : after) nearest = std::min(nearest, distance_to_edge(point, a, b));
    EXPECT_LE(nearest, limit);
  }
}

/// The triangles after the first `count` collapses, by following each point from collapse to collapse.
std::vector<Triangle> replayed_plainly(const CollapseRecord& record, size_t count) {
  std::vector<uint32_t> goes_to(record.origin.size());
  std::iota(goes_to.begin(), goes_to.end(), 0U);
  for (size_t i = 0; i < count; ++i) goes_to[record.collapses[i].removed] = record.collapses[i].kept;
  std::vector<Triangle> triangles = record.corners;
  for (Triangle& t : triangles) {
    for (uint32_t& point : t) {
      while (goes_to[point] != point) point = goes_to[point];
    }
  }
  std::erase_if(triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return triangles;
}

TEST(Decimation, a_replayed_prefix_is_what_a_decimation_to_that_count_leaves) {
  for (const Mesh& mesh : {rabbit(), make_torus(32, 0.35F), make_plane(20)}) {
    const CollapseRecord record = record_collapses(mesh);
    for (const size_t asked : {mesh.triangles.size() / 2, mesh.triangles.size() / 8}) {
      const std::vector<Triangle> replayed = replayed_plainly(record, collapses_for(record, asked));
      EXPECT_EQ(canonical(replayed), canonical(decimate_directly(mesh, asked, DecimationRules::ours)))
          << asked;
    }
  }
}

TEST(Decimation, the_same_mesh_gives_the_same_record) {
  const Mesh torus = make_torus(32, 0.35F);
  EXPECT_EQ(record_collapses(torus), record_collapses(torus));
  Mesh moved = torus;
  moved.positions[5] *= 1.01F;
  EXPECT_NE(record_collapses(torus), record_collapses(moved));
}

TEST(Decimation, units_do_not_matter) {
  const Mesh torus = make_torus(24, 0.35F);
  for (const float scale : {0x1p-60F, 0x1p60F}) {
    Mesh scaled = torus;
    for (glm::vec3& p : scaled.positions) p *= scale;
    EXPECT_EQ(record_collapses(scaled).collapses, record_collapses(torus).collapses);
  }
}

TEST(Decimation, the_record_grows_in_step_with_the_mesh) {
  const auto bytes_per_face = [](const Mesh& mesh) {
    const CollapseRecord record = record_collapses(mesh);
    const size_t bytes = 12 * record.corners.size() + 4 * record.origin.size() +
                         4 * record.next_equal.size() + 8 * record.collapses.size() + 4 * record.faces.size();
    return static_cast<double>(bytes) / static_cast<double>(mesh.triangles.size());
  };
  EXPECT_LT(bytes_per_face(make_torus(16, 0.35F)), 23.0);
  EXPECT_LT(bytes_per_face(make_torus(96, 0.35F)), 23.0);
}

TEST(Decimation, a_hundred_components_each_stay_closed) {
  Mesh many = make_sphere(6);
  for (int i = 1; i < 100; ++i)
    many = joined(std::move(many), make_sphere(6), {3.0F * (i % 10), 0, 3.0F * (i / 10)});
  const CollapseRecord record = record_collapses(many);
  EXPECT_EQ(record.faces.back(), 400U) << "a tetrahedron each";
  for (const size_t asked : {4000, 1000, 400})
    EXPECT_TRUE(is_closed_outwards(mesh_at_level(many, record, static_cast<size_t>(asked)))) << asked;
}

TEST(Decimation, a_soup_of_separate_triangles_decimates_like_the_welded_mesh) {
  const Mesh torus = make_torus(24, 0.35F);
  Mesh soup;
  for (const Triangle& t : torus.triangles) {
    const auto base = static_cast<uint32_t>(soup.positions.size());
    for (const uint32_t vertex : t) {
      soup.positions.push_back(torus.positions[vertex]);
      soup.normals.push_back(torus.normals[vertex]);
    }
    soup.triangles.push_back({base, base + 1, base + 2});
  }
  const CollapseRecord record = record_collapses(soup);
  const Mesh level = mesh_at_level(soup, record, 200);
  EXPECT_TRUE(is_closed_outwards(level));
  EXPECT_EQ(level.triangles.size(), 200U);
  EXPECT_EQ(level.positions.size(), 100U) << "equal normals at one place are one vertex (torus: V = F / 2)";
}

TEST(Decimation, sheets_that_meet_in_one_line_stay_together) {
  // Three half planes around the x axis, joined there: every edge on the axis has three faces.
  Mesh sheets;
  constexpr uint32_t kCells = 8;
  for (int sheet = 0; sheet < 3; ++sheet) {
    const float angle = 2.0943951F * static_cast<float>(sheet);
    const auto base = static_cast<uint32_t>(sheets.positions.size());
    for (uint32_t i = 0; i <= kCells; ++i) {
      for (uint32_t j = 0; j <= kCells; ++j) {
        const auto r = static_cast<float>(j);
        sheets.positions.emplace_back(static_cast<float>(i), r * std::cos(angle), r * std::sin(angle));
      }
    }
    for (uint32_t i = 0; i < kCells; ++i) {
      for (uint32_t j = 0; j < kCells; ++j) {
        const uint32_t a = base + i * (kCells + 1) + j;
        sheets.triangles.push_back({a, a + 1, a + kCells + 2});
        sheets.triangles.push_back({a, a + kCells + 2, a + kCells + 1});
      }
    }
  }
  smooth_normals(sheets);
  const CollapseRecord record = record_collapses(sheets);
  EXPECT_LT(record.faces.back(), 60U);
  const Mesh level = mesh_at_level(sheets, record, 1);
  EXPECT_EQ(level.notes.size(), 1U) << "one face cannot be reached";
  double area = 0.0;
  std::set<float> on_axis;
  for (const Triangle& t : level.triangles) {
    area += glm::length(area_normal(level, t));
    for (const uint32_t vertex : t) {
      if (level.positions[vertex].y == 0.0F && level.positions[vertex].z == 0.0F)
        on_axis.insert(level.positions[vertex].x);
    }
  }
  EXPECT_NEAR(area, 3.0 * kCells * kCells, 1e-3);
  EXPECT_EQ(on_axis.size(), kCells + 1) << "the line they share does not move";
}

TEST(Decimation, faces_without_area_are_decimated_away) {
  Mesh plane = make_plane(8);
  const size_t good = plane.triangles.size();
  plane.triangles.push_back({0, 1, 2});  // three in a row
  plane.triangles.push_back({3, 3, 4});
  const CollapseRecord record = record_collapses(plane);
  EXPECT_EQ(record.faces.front(), good + 1) << "a vertex named twice is in no level";
  EXPECT_LE(record.faces.back(), good / 4);
  EXPECT_TRUE(is_record_of(record, plane));
}

TEST(Decimation, a_mesh_without_triangles_has_an_empty_record) {
  const CollapseRecord record = record_collapses(Mesh());
  EXPECT_TRUE(record.collapses.empty());
  EXPECT_TRUE(mesh_at_level(Mesh(), record, 10).triangles.empty());
}

/// Two cones on one ring: its tips have `sides` faces each.
Mesh double_cone(uint32_t sides) {
  Mesh mesh;
  for (uint32_t i = 0; i < sides; ++i) {
    const double angle = 6.283185307179586 * i / sides;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0.01 * std::sin(7 * angle));
    const uint32_t next = (i + 1) % sides;
    mesh.triangles.push_back({i, next, sides});
    mesh.triangles.push_back({next, i, sides + 1});
  }
  mesh.positions.emplace_back(0, 0, 1);
  mesh.positions.emplace_back(0, 0, -1);
  smooth_normals(mesh);
  return mesh;
}

// Asking about each edge of a tip with each that goes would take hours.
TEST(Decimation, takes_no_longer_where_a_vertex_has_thousands_of_faces) {
  const Mesh mesh = double_cone(4000);
  const CollapseRecord record = record_collapses(mesh);
  const Mesh level = mesh_at_level(mesh, record, 100);
  EXPECT_LE(level.triangles.size(), 100U);
  EXPECT_TRUE(is_closed_outwards(level));
}

}  // namespace
}  // namespace inkbench
