// SPDX-License-Identifier: MIT
// An STL repeats its corners facet by facet. Where it rounds them anew each time, its surface must still
// close.
#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "pipeline/mesh/closed.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/levels/decimation.h"
#include "pipeline/mesh/mesh_from_soup.h"
#include "pipeline/mesh/shapes/primitives.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// `steps` floats up or down.
float stepped(float value, int steps) {
  for (; steps != 0; steps -= steps > 0 ? 1 : -1)
    value = std::nextafter(value, steps > 0 ? INFINITY : -INFINITY);
  return value;
}

/// Every triangle with corners of its own, scaled, moved, and each coordinate wrong by up to `steps` floats.
PolygonSoup soup_of(const Mesh& mesh, float scale, const glm::vec3& offset, int steps) {
  PolygonSoup soup;
  soup.corners_are_rounded = true;
  uint32_t random = 1;
  for (const auto& t : mesh.triangles) {
    soup.corner_counts.push_back(3);
    for (const uint32_t vertex : t) {
      glm::vec3 point = mesh.positions[vertex] * scale + offset;
      for (int axis = 0; axis < 3; ++axis) {
        random = random * 1664525U + 1013904223U;
        point[axis] = stepped(point[axis], static_cast<int>((random >> 16) % (2 * steps + 1)) - steps);
      }
      soup.corners.push_back(static_cast<int32_t>(soup.points.size()));
      soup.points.emplace_back(point);
    }
  }
  return soup;
}

std::string binary_stl_of(const PolygonSoup& soup) {
  std::string bytes(80, ' ');
  const auto append = [&](const void* data, size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  };
  const auto facets = static_cast<uint32_t>(soup.corner_counts.size());
  append(&facets, 4);
  for (uint32_t facet = 0; facet < facets; ++facet) {
    bytes.append(12, '\0');
    for (size_t corner = 0; corner < 3; ++corner) {
      const glm::vec3 point = soup.points[3 * size_t{facet} + corner];
      append(&point, 12);
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

TEST(RoundedCorners, meet_again_whatever_the_unit_and_the_place) {
  const Mesh torus = make_torus(24, 0.35F);
  struct Case {
    float scale, offset;
    int steps;
  };
  for (const auto& [scale, offset, steps] :
       {Case{1, 0, 1}, {1e-20F, 0, 1}, {1e20F, 0, 1}, {1, 5, 1}, {3, -2000, 1}, {40, 1000, 1}}) {
    PolygonSoup soup = soup_of(torus, scale, glm::vec3(offset, -offset, 2 * offset), steps);
    const MeshOptions smooth{.smooth_below_deg = 180.0};
    const Mesh mesh = mesh_from_soup(soup, "x", smooth);
    soup.corners_are_rounded = false;
    EXPECT_FALSE(is_closed_outwards(mesh_from_soup(soup, "x")));
    EXPECT_EQ(mesh.positions.size(), torus.positions.size()) << scale << " at " << offset;
    EXPECT_EQ(mesh.triangles.size(), torus.triangles.size());
    EXPECT_TRUE(is_closed_outwards(mesh));
    ASSERT_EQ(mesh.notes.size(), 1U);
    EXPECT_THAT(mesh.notes[0], HasSubstr("vertices into others that rounding alone kept apart"));
  }
}

TEST(RoundedCorners, what_lies_further_apart_stays_apart) {
  PolygonSoup soup;
  for (const float gap : {0.0F, 2e-6F}) {
    soup.points.insert(soup.points.end(), {{gap, 0, 0}, {1, gap, 0}, {0, 1, gap}});
    for (int i = 0; i < 3; ++i) soup.corners.push_back(static_cast<int32_t>(soup.corners.size()));
    soup.corner_counts.push_back(3);
  }
  soup.corners_are_rounded = true;
  EXPECT_EQ(mesh_from_soup(soup, "x", {.smooth_below_deg = 180.0}).positions.size(), 6U);
}

TEST(RoundedCorners, soups_without_extent_or_numbers_are_survived) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const glm::vec3 point : {glm::vec3(0), glm::vec3(7), glm::vec3(nan), glm::vec3(INFINITY, 0, 0)}) {
    PolygonSoup soup;
    soup.points.assign(3, point);
    soup.corner_counts = {3};
    soup.corners = {0, 1, 2};
    soup.corners_are_rounded = true;
    EXPECT_THAT(error_of([&] { mesh_from_soup(soup, "x"); }), HasSubstr("no face can be drawn"));
  }
}

TEST(RoundedCorners, points_that_are_no_numbers_and_indices_out_of_range_are_left_to_the_rest) {
  PolygonSoup soup;
  soup.points = {
      {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}, {0, 1e-7, 0}};
  soup.corner_counts = {3, 3, 3, 3};
  soup.corners = {0, 1, 2, 3, 1, 2, 4, 1, 99, 4, 0, 1};
  soup.corners_are_rounded = true;
  const Mesh mesh = mesh_from_soup(soup, "x");
  EXPECT_EQ(mesh.triangles.size(), 1U);
  EXPECT_THAT(mesh.notes, Contains(HasSubstr("index 99")));
  EXPECT_THAT(mesh.notes, Contains("Dropped 1 face with a corner at NaN or infinity."));
  EXPECT_THAT(mesh.notes, Contains("Dropped 1 face without area."));
  EXPECT_THAT(mesh.notes, Contains("Merged 1 vertex into others that rounding alone kept apart."));
}

TEST(RoundedCorners, an_stl_file_loads_closed_and_decimates_like_the_shape) {
  const TemporaryFolder folder;
  const Mesh torus = make_torus(24, 0.35F);
  const Mesh clean =
      load_mesh_file(folder.write("clean.stl", binary_stl_of(soup_of(torus, 1, glm::vec3(0), 0))));
  EXPECT_THAT(clean.notes, IsEmpty());
  const Mesh mesh = load_mesh_file(folder.write("t.stl", binary_stl_of(soup_of(torus, 1, glm::vec3(0), 1))));
  EXPECT_TRUE(is_closed_outwards(mesh));
  EXPECT_THAT(mesh.notes, Contains(HasSubstr("rounding")));
  const Mesh level = mesh_at_level(mesh, record_collapses(mesh), 200);
  EXPECT_TRUE(is_closed_outwards(level));
  EXPECT_EQ(level.triangles.size(), 200U);
}

}  // namespace
}  // namespace inkbench
