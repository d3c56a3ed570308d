// SPDX-License-Identifier: MIT
// The detector `dihedral` against planes in double precision and on shapes whose lines are known.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "pipeline/explain.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/placing/placed_lines.h"
#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/cpu_rays.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

constexpr int kViewPx = 96;
constexpr float kViewDistance = 5.0F, kViewFov = 40.0F;

/// A camera on the z axis that looks at the origin.
Settings straight_view() {
  Settings settings;
  settings.image = {kViewPx, kViewPx, Precision::float32};
  settings.camera.eye = {0.0F, 0.0F, kViewDistance};
  settings.camera.target = glm::vec3(0.0F);
  settings.camera.fov = kViewFov;
  settings.edges.method = EdgeMethod::dihedral;
  return settings;
}

/// World units that a pixel covers at the origin.
double pixel_at_origin() {
  return 2.0 * std::tan(kViewFov * std::numbers::pi / 360.0) * kViewDistance / kViewPx;
}

Settings with_mesh(const std::filesystem::path& file) {
  Settings settings = straight_view();
  settings.models = {{.name = "mesh", .shape = Shape::mesh, .mesh = file.string()}};
  return settings;
}

/// Two half planes that meet along x = `edge` at z = 0 and go back from there, each by half of `angle_deg`.
std::string roof_obj(double edge, double angle_deg) {
  const double back = 20.0 * std::tan(angle_deg / 2.0 * std::numbers::pi / 180.0);
  return fmt::format(
      "v {0} -20 0\nv {0} 20 0\nv {1} -20 {3}\nv {1} 20 {3}\nv {2} -20 {3}\nv {2} 20 {3}\n"
      "f 3 1 2 4\nf 1 5 6 2\n",
      edge, edge - 20.0, edge + 20.0, -back);
}

/// Half planes that face the camera, the right one `deeper` away; nothing joins them.
std::string terrace_obj(double deeper) {
  return fmt::format(
      "v -20 -20 0\nv 0.01 -20 0\nv 0.01 20 0\nv -20 20 0\nv 0.01 -20 {0}\nv 20 -20 {0}\nv 20 20 {0}\n"
      "v 0.01 20 {0}\nf 1 2 3 4\nf 5 6 7 8\n",
      -deeper);
}

int64_t line_pixels(const Settings& settings) {
  Pipeline pipeline;
  const Image lines = pipeline.at(settings).raw(BufferName::lines);
  return std::count(lines.samples.begin(), lines.samples.end(), 1.0F);
}

TEST(Dihedral, a_plane_at_any_slant_has_no_line) {
  for (const CameraProjection projection : {CameraProjection::perspective, CameraProjection::orthographic}) {
    for (const float slant_deg : {0.0F, 30.0F, 75.0F, 89.0F}) {
      Settings settings = straight_view();
      settings.camera.projection = projection;
      settings.models = {{.name = "plane", .shape = Shape::plane, .segments = 7, .size = 4000.0F}};
      settings.models[0].rotation = {90.0F - slant_deg, 20.0F, 0.0F};
      settings.camera.far = 1e5F;
      settings.dihedral = {.angle = 0.5F, .gap = 0.02F};
      Pipeline pipeline;
      const Image angles = pipeline.at(settings).raw(BufferName::pair_angles);
      const Image ids = pipeline.at(settings).raw(BufferName::object_id);
      ASSERT_GT(std::count(ids.samples.begin(), ids.samples.end(), 1.0F), kViewPx * kViewPx / 4);
      const Image strength = pipeline.at(settings).raw(BufferName::edge_strength);
      for (int y = 2; y < kViewPx - 2; ++y) {
        for (int x = 2; x < kViewPx - 2; ++x) {
          if (ids.at(x, y) == 0.0F || ids.at(x + 1, y) == 0.0F || ids.at(x, y - 1) == 0.0F ||
              ids.at(x - 1, y) == 0.0F || ids.at(x, y + 1) == 0.0F)
            continue;
          ASSERT_LT(strength.at(x, y), 1.0F) << slant_deg << " at " << x << ", " << y;
        }
      }
    }
  }
}

/// The largest angle and gap of a slanted plane's pairs away from the image's border.
std::pair<float, float> largest_of_slanted_plane(Precision precision) {
  Settings settings = straight_view();
  settings.image.precision = precision;
  settings.models = {{.name = "plane", .shape = Shape::plane, .segments = 7, .size = 40.0F}};
  settings.models[0].rotation = {60.0F, 20.0F, 0.0F};
  Pipeline pipeline;
  const Image angles = pipeline.at(settings).raw(BufferName::pair_angles);
  const Image gaps = pipeline.at(settings).raw(BufferName::pair_gaps);
  std::pair<float, float> largest;
  for (int y = kViewPx / 4; y < kViewPx * 3 / 4; ++y) {
    for (int x = kViewPx / 4; x < kViewPx * 3 / 4; ++x) {
      largest.first = std::max(largest.first, std::abs(angles.at(x, y)));
      largest.second = std::max(largest.second, std::abs(gaps.at(x, y)));
    }
  }
  return largest;
}

TEST(Dihedral, sixteen_bit_depths_part_a_plane_and_24_bits_do_not) {
  constexpr float kMeeting = 1.0F / 256.0F;
  EXPECT_LE(largest_of_slanted_plane(Precision::float32).second, kMeeting);
  EXPECT_GT(largest_of_slanted_plane(Precision::half).second, 5 * kMeeting);
  EXPECT_LE(largest_of_slanted_plane(Precision::depth24).second, kMeeting);
}

TEST(Dihedral, sixteen_bit_normals_keep_a_plane_flat) {
  EXPECT_LT(largest_of_slanted_plane(Precision::half).first, 0.1F);
}

TEST(Dihedral, a_crease_fires_just_above_the_limit_and_not_just_below) {
  for (const double angle : {20.0, 40.0, 75.0}) {
    TempFolder folder;
    Settings settings = with_mesh(folder.write("roof.obj", roof_obj(0.013, angle)));
    settings.dihedral.angle = static_cast<float>(angle - 0.1);
    EXPECT_GE(line_pixels(settings), kViewPx) << angle;
    settings.dihedral.angle = static_cast<float>(angle + 0.1);
    EXPECT_EQ(line_pixels(settings), 0) << angle;
  }
}

TEST(Dihedral, a_step_fires_just_above_the_gap_and_not_just_below) {
  TempFolder folder;
  Settings settings = with_mesh(folder.write("terrace.obj", terrace_obj(0.5 * pixel_at_origin())));
  settings.dihedral.gap = 0.48F;
  EXPECT_GE(line_pixels(settings), kViewPx);
  settings.dihedral.gap = 0.52F;
  EXPECT_EQ(line_pixels(settings), 0);
}

TEST(Dihedral, a_crease_lies_where_its_planes_meet) {
  const int middle = kViewPx / 2;
  for (const double offset_px : {-0.4, -0.1, 0.0, 0.25, 0.45}) {
    TempFolder folder;
    const double edge = (0.5 + offset_px) * pixel_at_origin();
    const Settings settings = with_mesh(folder.write("roof.obj", roof_obj(edge, 90.0)));
    Pipeline pipeline;
    const Image placed = pipeline.at(settings).value<PlacedLines>()->read(0, 4);
    for (int y = 3; y < kViewPx - 3; ++y) {
      const PlacedLine line = placed_at(placed, middle, y);
      ASSERT_EQ(line.line_class, EdgeClass::crease) << offset_px << ", row " << y;
      ASSERT_NEAR(line.offset_x, offset_px, 0.01) << "row " << y;
      ASSERT_EQ(placed_at(placed, middle - 1, y).line_class, EdgeClass::none);
      ASSERT_EQ(placed_at(placed, middle + 1, y).line_class, EdgeClass::none);
    }
  }
}

TEST(Dihedral, a_step_is_the_nearer_surfaces) {
  TempFolder folder;
  const Settings settings = with_mesh(folder.write("terrace.obj", terrace_obj(1.0)));
  Pipeline pipeline;
  const Image placed = pipeline.at(settings).value<PlacedLines>()->read(0, 4);
  for (int y = 0; y < kViewPx; ++y) {
    for (int x = 0; x < kViewPx; ++x)
      ASSERT_EQ(placed_at(placed, x, y).line_class,
                x == kViewPx / 2 - 1 ? EdgeClass::silhouette : EdgeClass::none)
          << x << ", " << y;
  }
}

TEST(Dihedral, neither_near_and_far_nor_the_scenes_scale_change_a_line) {
  Settings settings = analytic_scene();
  settings.edges.method = EdgeMethod::dihedral;
  Pipeline pipeline;
  const Image lines = pipeline.at(settings).raw(BufferName::lines);
  Settings other_planes = settings;
  other_planes.camera.near = 0.01F;
  other_planes.camera.far = 1000.0F;
  EXPECT_LT(largest_difference(pipeline.at(other_planes).raw(BufferName::lines), lines), 0.5);
  for (const float scale : {0.001F, 1000.0F}) {
    Settings scaled = settings;
    for (glm::vec3* point : {&scaled.camera.eye, &scaled.camera.target}) *point *= scale;
    scaled.camera.near *= scale;
    scaled.camera.far *= scale;
    for (ModelParams& model : scaled.models) {
      model.position *= scale;
      if (model.size > 0.0F) model.size *= scale;
      if (model.size <= 0.0F) model.scale *= scale;
    }
    EXPECT_LT(largest_difference(pipeline.at(scaled).raw(BufferName::lines), lines), 0.5) << scale;
  }
}

TEST(Dihedral, facets_that_light_hides_are_no_lines_by_the_shading_normals) {
  Settings settings = straight_view();
  settings.models = {{.name = "ball", .shape = Shape::sphere, .segments = 4, .size = 3.0F}};
  settings.models[0].normals = ModelNormals::smooth;
  const auto inner_lines = [&] {
    Pipeline pipeline;
    const Image classes = pipeline.at(settings).raw(BufferName::edge_class);
    return std::count_if(classes.samples.begin(), classes.samples.end(),
                         [](float value) { return value > static_cast<float>(EdgeClass::silhouette); });
  };
  EXPECT_GT(inner_lines(), 50);
  settings.dihedral.normals = BendNormals::both;
  EXPECT_GT(inner_lines(), 50);
  settings.dihedral.normals = BendNormals::shading;
  EXPECT_EQ(inner_lines(), 0);
}

/// Angle and gap from a pixel to its neighbour by the planes through both, in double precision.
struct ExpectedPair {
  double angle_deg = 0, gap_px = 0;
};
ExpectedPair expected_pair(const reference::Surface& surface, const Settings& settings, int x, int y, int dx,
                           int dy) {
  const int width = settings.image.width, height = settings.image.height;
  struct Point {
    glm::dvec3 ray, normal;
    double distance;
  };
  const auto point = [&](int px, int py) {
    glm::dvec3 normal;
    for (int c = 0; c < 3; ++c) normal[c] = 2.0 * surface.normal.at(px, py, c) - 1.0;
    return Point{reference::pixel_ray(settings.camera, px, py, width, height), glm::normalize(normal),
                 surface.depth.at(px, py) * settings.camera.far};
  };
  const Point a = point(x, y), b = point(x + dx, y + dy);
  const double pixel = 2.0 * std::tan(settings.camera.fov * std::numbers::pi / 360.0) / height;
  // How far each point is off the other's plane, in pixels' sizes there.
  const glm::dvec3 apart = b.ray * b.distance - a.ray * a.distance;
  const double off_a = glm::dot(a.normal, apart) / (a.distance * pixel);
  const double off_b = glm::dot(b.normal, apart) / (b.distance * pixel);
  // Both planes on both rays, as 1 / distance: they meet between the pixels where the order changes.
  const double a_at_b = glm::dot(a.normal, b.ray) / (glm::dot(a.normal, a.ray) * a.distance);
  const double b_at_a = glm::dot(b.normal, a.ray) / (glm::dot(b.normal, b.ray) * b.distance);
  const bool they_meet = (1.0 / a.distance - b_at_a) * (a_at_b - 1.0 / b.distance) <= 0.0;
  return {glm::degrees(std::acos(std::clamp(glm::dot(a.normal, b.normal), -1.0, 1.0))),
          they_meet ? 0.0 : std::min(std::abs(off_a), std::abs(off_b))};
}

TEST(Dihedral, pairs_equal_planes_in_double_precision) {
  Settings settings = analytic_scene();
  settings.edges.method = EdgeMethod::dihedral;
  settings.models.erase(settings.models.begin() + 1);  // the ball, whose facets are no exact sphere
  const reference::Surface surface = reference::cast_rays(settings);
  Pipeline pipeline;
  const Image angles = pipeline.at(settings).raw(BufferName::pair_angles);
  const Image gaps = pipeline.at(settings).raw(BufferName::pair_gaps);
  const Image ids = pipeline.at(settings).raw(BufferName::object_id);
  int compared = 0, bends = 0, undecided = 0;
  for (int y = 1; y < settings.image.height; ++y) {
    for (int x = 0; x + 1 < settings.image.width; ++x) {
      for (int axis = 0; axis < 2; ++axis) {
        const int dx = axis == 0 ? 1 : 0, dy = axis == 0 ? 0 : -1;
        const double id = surface.object_id.at(x, y), other = surface.object_id.at(x + dx, y + dy);
        if (ids.at(x, y) != static_cast<float>(id) || ids.at(x + dx, y + dy) != static_cast<float>(other)) {
          ++undecided;  // a pixel whose centre an outline runs through
          continue;
        }
        if (id != other) {
          ASSERT_GT(std::abs(gaps.at(x, y, axis)), 50000.0F);
          continue;
        }
        if (id == 0.0) continue;
        const ExpectedPair expected = expected_pair(surface, settings, x, y, dx, dy);
        ASSERT_NEAR(std::abs(angles.at(x, y, axis)), expected.angle_deg, 0.08) << x << ", " << y;
        ASSERT_NEAR(std::abs(gaps.at(x, y, axis)), expected.gap_px, 0.01 + 0.002 * expected.gap_px)
            << x << ", " << y;
        ++compared;
        bends += expected.angle_deg > 1.0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(compared, 10000);
  EXPECT_GT(bends, 20);
  EXPECT_LT(undecided, 10);
}

TEST(Dihedral, the_planes_are_drawn_into_a_held_gbuffer_that_lacks_them_and_change_no_key) {
  Settings settings = small_scene();
  Pipeline pipeline;
  const Frame paper = pipeline.at(settings);
  paper.draw(BufferName::depth);
  EXPECT_EQ(paper.value<GBufferPass>()->surface.id(), 0U);
  const Image depth = paper.raw(BufferName::depth);
  settings.edges.method = EdgeMethod::dihedral;
  const Frame ours = pipeline.at(settings);
  EXPECT_EQ(ours.key_of<GBufferPass>(), paper.key_of<GBufferPass>());
  ours.draw(BufferName::lines);
  EXPECT_NE(ours.value<GBufferPass>()->surface.id(), 0U);
  EXPECT_EQ(pipeline.counts()["gbuffer"].runs, 2);
  EXPECT_EQ(ours.raw(BufferName::depth), depth);
}

TEST(Dihedral, a_change_of_the_limits_measures_no_pair_again) {
  Settings settings = small_scene();
  settings.edges.method = EdgeMethod::dihedral;
  Pipeline pipeline;
  pipeline.at(settings).draw(BufferName::lines);
  settings.dihedral.angle = 20.0F;
  settings.dihedral.gap = 2.0F;
  pipeline.at(settings).draw(BufferName::lines);
  EXPECT_EQ(pipeline.counts()["pairs"].runs, 1);
  EXPECT_EQ(pipeline.counts()["dihedral_place"].runs, 2);
}

TEST(Dihedral, explain_says_what_is_drawn_of_every_pixel) {
  Settings settings = analytic_scene();
  settings.edges.method = EdgeMethod::dihedral;
  settings.edges.weak = 0.7F;
  Pipeline pipeline;
  const Frame frame = pipeline.at(settings);
  const KeptMaps maps = keep_maps(frame);
  const Image placed = frame.value<PlacedLines>()->read(0, 4);
  int lines = 0;
  for (int y = 0; y < settings.image.height; ++y) {
    for (int x = 0; x < settings.image.width; ++x) {
      const Explanation explained = explain_pixel(maps, x, y);
      const EdgeClass line_class = placed_at(placed, x, y).line_class;
      const std::string name(
          line_class == EdgeClass::none ? "" : kEdgeClassNames[static_cast<size_t>(line_class)]);
      ASSERT_EQ(explained.line_class, name) << x << ", " << y << ": " << explained.verdict;
      ASSERT_NEAR(explained.sum, explained.drawn, 1e-3 * explained.sum + 1e-6) << x << ", " << y;
      lines += explained.is_line ? 1 : 0;
    }
  }
  EXPECT_GT(lines, 300);
}

}  // namespace
}  // namespace inkbench
