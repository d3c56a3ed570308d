// SPDX-License-Identifier: MIT
// Reference lines of shapes whose lines are known exactly, tier 1.
#include <gtest/gtest.h>

#include <functional>
#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "pipeline/mesh/shapes/primitives.h"
#include "tests/unit/reference_support.h"

namespace inkbench {
namespace {

using Sdf =
    std::function<double(const glm::dvec3&)>;  ///< Signed distance to an exact shape, negative inside.

Sdf sphere_at(const glm::dvec3& centre, double radius) {
  return [=](const glm::dvec3& p) { return glm::length(p - centre) - radius; };
}

double rounded_box_distance(const glm::dvec3& p, double fillet) {
  const glm::dvec3 q = glm::abs(p) - glm::dvec3(0.5 - fillet);
  return glm::length(glm::max(q, 0.0)) + std::min(std::max({q.x, q.y, q.z}), 0.0) - fillet;
}

/// Least distance from the ray through a pixel to a convex shape, as an angle in px: 0 on the true outline.
double miss_px(const ReferenceScene& scene, const glm::dvec2& pixel, const Sdf& shape) {
  const double half = std::tan(glm::radians(scene.camera.fov / 2.0));
  const glm::dvec3 in_view((2.0 * pixel.x / scene.width_px - 1.0) * half * scene.aspect(),
                           (1.0 - 2.0 * pixel.y / scene.height_px) * half, -1.0);
  const glm::dvec3 ray = glm::normalize(glm::transpose(glm::dmat3(view_matrix(scene.camera))) * in_view);
  const glm::dvec3 eye(scene.camera.eye);
  double low = 0.0;
  double high = 50.0;
  for (int i = 0; i < 100; ++i) {
    const double a = low + (high - low) / 3.0;
    const double b = high - (high - low) / 3.0;
    (shape(eye + a * ray) < shape(eye + b * ray) ? high : low) =
        shape(eye + a * ray) < shape(eye + b * ray) ? b : a;
  }
  return shape(eye + low * ray) / low * scene.height_px / (2.0 * half);
}

void expect_closed_outline(const ReferenceScene& scene, const ReferenceLines& lines, const Sdf& shape) {
  const std::vector<Polyline> silhouettes = of_class(lines, LineClass::silhouette);
  ASSERT_EQ(silhouettes.size(), 1U);
  EXPECT_TRUE(is_closed_line(silhouettes[0]));
  double worst = 0.0;
  for (const glm::dvec2& point : points_along(silhouettes))
    worst = std::max(worst, std::abs(miss_px(scene, point, shape)));
  EXPECT_LT(worst, 0.5);
}

void expect_only(const ReferenceLines& lines, std::initializer_list<LineClass> allowed) {
  for (const Polyline& line : lines.polylines) {
    EXPECT_NE(std::find(allowed.begin(), allowed.end(), line.line_class), allowed.end())
        << name_of(line.line_class) << " of " << line.points.size() << " points";
  }
}

TEST(ReferenceShapes, sphere_is_one_closed_circle) {
  ReferenceScene scene;
  scene.add(make_sphere(64));
  const ReferenceLines lines = scene.lines();
  expect_closed_outline(scene, lines, sphere_at({0, 0, 0}, 1.0));
  expect_only(lines, {LineClass::silhouette, LineClass::object});
  // Worked out by hand: the tangent cone's half angle is asin(1/5).
  const double radius = std::tan(std::asin(0.2)) * 128.0 / std::tan(glm::radians(22.5));
  const std::vector<Polyline> silhouettes = of_class(lines, LineClass::silhouette);
  for (const glm::vec2& point : silhouettes[0].points)
    EXPECT_NEAR(glm::length(glm::dvec2(point) - glm::dvec2(128.0)), radius, 0.3);
  EXPECT_NEAR(length_of(silhouettes[0]), 2.0 * std::numbers::pi * radius, 8.0);
  const std::vector<Polyline> objects = of_class(lines, LineClass::object);
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_TRUE(is_closed_line(objects[0]));
  EXPECT_EQ(objects[0].object_id, 1);
  for (const glm::dvec2& point : points_along(objects)) EXPECT_LT(distance_to(point, silhouettes), 1.5);
}

TEST(ReferenceShapes, spheres_circle_is_one_piece_from_anywhere) {
  for (int i = 0; i < 12; ++i) {
    for (const int size : {64, 300}) {
      ReferenceScene scene;
      scene.width_px = size;
      scene.height_px = size * 3 / 4;
      scene.camera.eye = {4.0 * std::sin(i), 2.5 * std::cos(1.7 * i), 4.0 * std::cos(i)};
      scene.camera.target = {0.3, 0.2, 0.1};
      scene.add(make_sphere(40), glm::translate(glm::mat4(1.0F), glm::vec3(0.1, -0.2, 0.3)));
      expect_closed_outline(scene, scene.lines(), sphere_at({0.1, -0.2, 0.3}, 1.0));
    }
  }
}

TEST(ReferenceShapes, stretched_sphere_is_an_ellipsoids_outline) {
  ReferenceScene scene;
  scene.camera.eye = {2, 3, 5};
  scene.add(make_sphere(64),
            glm::scale(glm::rotate(glm::mat4(1.0F), 0.7F, glm::vec3(0, 0, 1)), glm::vec3(1.5, 0.5, 1)));
  const ReferenceLines lines = scene.lines();
  const std::vector<Polyline> silhouettes = of_class(lines, LineClass::silhouette);
  ASSERT_EQ(silhouettes.size(), 1U);
  EXPECT_TRUE(is_closed_line(silhouettes[0]));
  // The ids' border is the outline as the rasteriser saw it.
  for (const glm::dvec2& point : points_along(of_class(lines, LineClass::object)))
    EXPECT_LT(distance_to(point, silhouettes), 1.2);
}

// ---- Box

struct BoxEdges {
  std::vector<std::array<glm::dvec3, 2>> silhouette, crease, hidden;
};

/// The 12 edges of the unit box by how its sides face an eye outside; one that is infinitely far away in an
/// orthographic view.
BoxEdges box_edges(const glm::dvec3& eye, bool at_infinity) {
  const double least = at_infinity ? 0.0 : 1.0;
  BoxEdges edges;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (const double at_u : {-0.5, 0.5}) {
      for (const double at_v : {-0.5, 0.5}) {
        std::array<glm::dvec3, 2> edge;
        for (const int end : {0, 1}) {
          edge[end][axis] = end - 0.5;
          edge[end][u] = at_u;
          edge[end][v] = at_v;
        }
        const int fronts = (eye[u] / at_u > least ? 1 : 0) + (eye[v] / at_v > least ? 1 : 0);
        (fronts == 2 ? edges.crease : fronts == 1 ? edges.silhouette : edges.hidden).push_back(edge);
      }
    }
  }
  return edges;
}

double largest_gap(const ReferenceScene& scene, const std::vector<std::array<glm::dvec3, 2>>& edges,
                   const std::vector<Polyline>& lines) {
  double worst = 0.0;
  for (const auto& edge : edges) {
    for (int i = 0; i <= 50; ++i) {
      const glm::dvec3 pixel = scene.pixel_of(glm::mix(edge[0], edge[1], i / 50.0));
      worst = std::max(worst, distance_to({pixel.x, pixel.y}, lines));
    }
  }
  return worst;
}

void expect_box(const glm::vec3& eye, int segments,
                CameraProjection projection = CameraProjection::perspective) {
  ReferenceScene scene;
  scene.camera.projection = projection;
  scene.camera.view_height = 2.5F;
  scene.camera.eye = eye;
  scene.camera.fov = 25.0F;
  scene.add(make_box(segments));
  const ReferenceLines lines = scene.lines();
  expect_only(lines, {LineClass::silhouette, LineClass::crease, LineClass::object});
  const std::vector<Polyline> silhouettes = of_class(lines, LineClass::silhouette);
  const std::vector<Polyline> creases = of_class(lines, LineClass::crease);
  ASSERT_EQ(silhouettes.size(), 1U);
  EXPECT_TRUE(is_closed_line(silhouettes[0]));
  EXPECT_EQ(creases.size(), 3U);
  const BoxEdges edges = box_edges(eye, is_orthographic(scene.camera));
  EXPECT_EQ(edges.silhouette.size() + edges.crease.size(), 9U);
  EXPECT_LT(largest_gap(scene, edges.silhouette, silhouettes), 0.01);
  EXPECT_LT(largest_gap(scene, edges.crease, creases), 0.51);  // a piece ends at its last visible sample
  EXPECT_LT(largest_gap(scene, edges.silhouette, lines.whole_creases), 0.51);
  EXPECT_LT(largest_gap(scene, edges.crease, lines.whole_creases), 0.51);
  double length = 0.0;
  for (const auto* group : {&edges.silhouette, &edges.crease}) {
    for (const auto& edge : *group)
      length += glm::length(glm::dvec2(scene.pixel_of(edge[0])) - glm::dvec2(scene.pixel_of(edge[1])));
  }
  EXPECT_NEAR(total_length(silhouettes) + total_length(creases), length, 2.0);  // none twice, none hidden
}

TEST(ReferenceShapes, box_shows_nine_edges_and_none_of_the_hidden_three) {
  expect_box({2.0F, 1.5F, 4.0F}, 1);
  expect_box({-3.0F, 2.0F, 2.5F}, 1);
  expect_box({2.2F, -3.0F, -2.8F}, 5);
}

TEST(ReferenceShapes, box_shows_nine_edges_in_orthographic_views) {
  expect_box({2.0F, 1.5F, 4.0F}, 1, CameraProjection::orthographic);
  // Where a perspective view from there shows a single side.
  expect_box({0.4F, -0.3F, 3.0F}, 1, CameraProjection::orthographic);
  expect_box({2.2F, -3.0F, -2.8F}, 5, CameraProjection::orthographic);
}

TEST(ReferenceShapes, box_seen_straight_on_is_a_square) {
  ReferenceScene scene;
  scene.add(make_box(3));
  const ReferenceLines lines = scene.lines();
  const std::vector<Polyline> silhouettes = of_class(lines, LineClass::silhouette);
  ASSERT_EQ(silhouettes.size(), 1U);
  EXPECT_TRUE(is_closed_line(silhouettes[0]));
  EXPECT_TRUE(of_class(lines, LineClass::crease).empty());
  const double side = 256.0 / (2.0 * 4.5 * std::tan(glm::radians(22.5)));
  EXPECT_NEAR(length_of(silhouettes[0]), 4.0 * side, 0.1);
}

// ---- Torus

constexpr double kTube = 0.45;

double torus_distance(const glm::dvec3& p) {
  return std::hypot(std::hypot(p.x, p.z) - 1.0, p.y) - kTube;
}

struct TorusContour {
  std::vector<glm::dvec2> visible, hidden, unclear;
};

/// Points at which the exact torus's normal is at a right angle to the view: for each angle around the ring,
/// A cos v + B sin v = tube, with A and B the eye's distance from the tube's centre along the ring's radius
/// and axis.
TorusContour torus_contour(const ReferenceScene& scene) {
  TorusContour contour;
  const glm::dvec3 eye(scene.camera.eye);
  for (int i = 0; i < 4000; ++i) {
    const double around = 2.0 * std::numbers::pi * i / 4000.0;
    const glm::dvec3 out(std::sin(around), 0.0, std::cos(around));
    const double a = glm::dot(out, eye) - 1.0;
    const double b = eye.y;
    for (const double sign : {-1.0, 1.0}) {
      const double v = std::atan2(b, a) + sign * std::acos(kTube / std::hypot(a, b));
      const glm::dvec3 point = out * (1.0 + kTube * std::cos(v)) + glm::dvec3(0.0, kTube * std::sin(v), 0.0);
      double deepest = 1.0;
      for (int step = 1; step < 2000; ++step)
        deepest = std::min(deepest, torus_distance(glm::mix(eye, point, step / 2000.0)));
      (deepest > -1e-4   ? contour.visible
       : deepest < -0.02 ? contour.hidden
                         : contour.unclear)
          .emplace_back(scene.pixel_of(point));
    }
  }
  return contour;
}

double nearest(const glm::dvec2& point, const std::vector<glm::dvec2>& points) {
  double best = INFINITY;
  for (const glm::dvec2& other : points) best = std::min(best, glm::length(other - point));
  return best;
}

void expect_torus(const glm::vec3& eye) {
  ReferenceScene scene;
  scene.camera.eye = eye;
  scene.camera.fov = 35.0F;
  scene.add(make_torus(128, static_cast<float>(kTube)));
  const ReferenceLines lines = scene.lines();
  const std::vector<Polyline> silhouettes = of_class(lines, LineClass::silhouette);
  const TorusContour contour = torus_contour(scene);
  EXPECT_GT(contour.hidden.size(), 500U);
  EXPECT_LT(contour.unclear.size(), 800U);  // of 8000
  for (const glm::dvec2& point : contour.visible) EXPECT_LT(distance_to(point, silhouettes), 1.0);
  std::vector<glm::dvec2> allowed = contour.visible;
  allowed.insert(allowed.end(), contour.unclear.begin(), contour.unclear.end());
  size_t strays = 0;
  const std::vector<glm::dvec2> drawn = points_along(silhouettes);
  for (const glm::dvec2& point : drawn) strays += nearest(point, allowed) > 1.5 ? 1 : 0;
  // Where a hidden line passes behind the edge of what hides it, the 3 x 3 test sees it for a pixel or so.
  EXPECT_LT(strays, drawn.size() / 200);
  size_t shown = 0;
  for (const glm::dvec2& point : contour.hidden) shown += distance_to(point, silhouettes) < 0.5 ? 1 : 0;
  EXPECT_LT(shown, contour.hidden.size() / 20);
  expect_only(lines, {LineClass::silhouette, LineClass::object, LineClass::suggestive});
}

TEST(ReferenceShapes, torus_shows_the_visible_part_of_its_silhouette_up_to_the_cusps) {
  expect_torus({0.0F, 2.5F, 5.0F});
  expect_torus({3.0F, 1.6F, 4.0F});
}

TEST(ReferenceShapes, torus_seen_along_its_axis_is_two_circles) {
  ReferenceScene scene;
  scene.camera.eye = {0, 6, 0};
  scene.camera.up = {0, 0, -1};
  scene.add(make_torus(64, 0.3F));
  const std::vector<Polyline> silhouettes = of_class(scene.lines(), LineClass::silhouette);
  ASSERT_EQ(silhouettes.size(), 2U);
  for (const Polyline& line : silhouettes) EXPECT_TRUE(is_closed_line(line));
}

TEST(ReferenceShapes, rounded_box_is_one_closed_outline) {
  for (const float fillet : {0.1F, 0.3F}) {
    ReferenceScene scene;
    scene.camera.eye = {2.0F, 1.5F, 4.0F};
    scene.camera.fov = 25.0F;
    scene.add(make_rounded_box(24, fillet));
    const ReferenceLines lines = scene.lines();
    expect_closed_outline(scene, lines, [&](const glm::dvec3& p) { return rounded_box_distance(p, fillet); });
    for (const LineClass absent :
         {LineClass::crease, LineClass::boundary, LineClass::suggestive, LineClass::valley})
      EXPECT_TRUE(of_class(lines, absent).empty()) << name_of(absent);
  }
}

// ---- Several objects, open and inside-out ones

TEST(ReferenceShapes, part_of_a_farther_object_behind_a_nearer_one_is_absent) {
  ReferenceScene scene;
  scene.width_px = 320;
  const glm::dvec3 near_centre(-0.3, 0.0, 1.0);
  const glm::dvec3 far_centre(0.8, 0.3, -1.5);
  scene.add(make_sphere(64), glm::translate(glm::mat4(1.0F), glm::vec3(far_centre)));
  scene.add(make_sphere(64), glm::translate(glm::mat4(1.0F), glm::vec3(near_centre)));
  const ReferenceLines lines = scene.lines();
  std::vector<Polyline> far_lines;
  std::vector<Polyline> near_lines;
  for (const Polyline& line : of_class(lines, LineClass::silhouette))
    (line.object_id == 1 ? far_lines : near_lines).push_back(line);
  ASSERT_EQ(near_lines.size(), 1U);
  EXPECT_TRUE(is_closed_line(near_lines[0]));
  ASSERT_EQ(far_lines.size(), 1U);
  EXPECT_FALSE(is_closed_line(far_lines[0]));
  const Sdf near_sphere = sphere_at(near_centre, 1.0);
  const Sdf far_sphere = sphere_at(far_centre, 1.0);
  for (const glm::dvec2& point : points_along(far_lines)) {
    EXPECT_GT(miss_px(scene, point, near_sphere), -1.6);
    EXPECT_LT(std::abs(miss_px(scene, point, far_sphere)), 0.5);
  }
  // All of the farther circle that is clearly outside the nearer one is there.
  for (int i = 0; i < 360; ++i) {
    const double distance = glm::length(glm::dvec3(scene.camera.eye) - far_centre);
    const glm::dvec3 axis = (glm::dvec3(scene.camera.eye) - far_centre) / distance;
    const glm::dvec3 side = glm::normalize(glm::cross(axis, glm::dvec3(0, 1, 0)));
    const double angle = glm::radians(static_cast<double>(i));
    const glm::dvec3 across = std::cos(angle) * side + std::sin(angle) * glm::cross(axis, side);
    const glm::dvec2 pixel(
        scene.pixel_of(far_centre + axis / distance + across * std::sqrt(1.0 - 1.0 / (distance * distance))));
    if (miss_px(scene, pixel, near_sphere) > 1.0) {
      EXPECT_LT(distance_to(pixel, far_lines), 0.7);
    }
  }
  // Along the overlap the objects' line follows the nearer circle and is the nearer object's.
  bool overlap_seen = false;
  for (const Polyline& line : of_class(lines, LineClass::object)) {
    for (const glm::vec2& point : line.points) {
      if (miss_px(scene, point, far_sphere) > -3.0) continue;
      overlap_seen = true;
      EXPECT_EQ(line.object_id, 2);
      EXPECT_LT(std::abs(miss_px(scene, point, near_sphere)), 1.5);
    }
  }
  EXPECT_TRUE(overlap_seen);
}

TEST(ReferenceShapes, object_behind_another_has_no_lines) {
  ReferenceScene scene;
  scene.add(make_box(2), glm::translate(glm::mat4(1.0F), glm::vec3(0, 0, -4)));
  scene.add(make_sphere(32));
  for (const Polyline& line : scene.lines().polylines) EXPECT_EQ(line.object_id, 2);
}

TEST(ReferenceShapes, plane_shows_its_rim_from_both_sides) {
  for (const float height : {2.0F, -2.0F}) {
    ReferenceScene scene;
    scene.camera.eye = {1.0F, height, 3.0F};
    scene.add(make_plane(6));
    const ReferenceLines lines = scene.lines();
    expect_only(lines, {LineClass::boundary, LineClass::object});
    const std::vector<Polyline> boundary = of_class(lines, LineClass::boundary);
    ASSERT_EQ(boundary.size(), 1U);
    EXPECT_TRUE(is_closed_line(boundary[0]));
    for (const glm::dvec3 corner :
         {glm::dvec3(0.5, 0, 0.5), glm::dvec3(-0.5, 0, 0.5), glm::dvec3(0.5, 0, -0.5)})
      EXPECT_LT(distance_to(glm::dvec2(scene.pixel_of(corner)), boundary), 1e-3);
  }
}

TEST(ReferenceShapes, room_seen_from_within_has_no_lines) {
  ReferenceScene scene;
  scene.camera.eye = {0.3F, 0.2F, 0.4F};
  scene.add(make_inside_out_sphere(32), glm::scale(glm::mat4(1.0F), glm::vec3(3.0F)));
  const ReferenceLines lines = scene.lines();
  EXPECT_TRUE(lines.polylines.empty());
  EXPECT_TRUE(lines.whole_creases.empty());
}

TEST(ReferenceShapes, floor_under_the_eye_is_cut_at_the_near_plane_and_the_image) {
  ReferenceScene scene;
  scene.camera.eye = {0.0F, 1.0F, 2.0F};
  scene.camera.target = {0.0F, 0.6F, 0.0F};
  scene.camera.fov = 90.0F;
  scene.add(make_plane(1), glm::scale(glm::mat4(1.0F), glm::vec3(10.0F)));
  const std::vector<Polyline> boundary = of_class(scene.lines(), LineClass::boundary);
  ASSERT_EQ(boundary.size(), 1U);  // the far side and parts of both others
  const glm::dvec2 corner(scene.pixel_of({5, 0, -5}));
  EXPECT_LT(distance_to(corner, boundary), 1e-3);
  EXPECT_LT(distance_to(glm::dvec2(scene.pixel_of({-5, 0, -4.5})), boundary), 1e-3);
  EXPECT_LT(distance_to(glm::dvec2(scene.pixel_of({2, 0, -5})), boundary), 1e-3);
  for (const glm::vec2& end : {boundary[0].points.front(), boundary[0].points.back()})
    EXPECT_TRUE(end.x < 0.6F || end.x > 255.4F || end.y > 255.4F) << end.x << ", " << end.y;
}

TEST(ReferenceShapes, what_is_off_screen_or_behind_has_no_lines) {
  ReferenceScene scene;
  scene.add(make_box(1), glm::translate(glm::mat4(1.0F), glm::vec3(20, 0, 0)));
  scene.add(make_box(1), glm::translate(glm::mat4(1.0F), glm::vec3(0, 0, 9)));
  scene.add(make_box(1), glm::translate(glm::mat4(1.0F), glm::vec3(0, 0, -30)));
  EXPECT_TRUE(scene.lines().polylines.empty());
}

// ---- Levels of a ladder

TEST(ReferenceShapes, coarse_level_has_the_creases_of_the_full_mesh) {
  const MeshTopology full = make_topology(make_sphere(64));
  const MeshTopology coarse = make_topology(make_sphere(4));
  const MeshFeatures features = make_features(full);
  EXPECT_FALSE(crease_edges(coarse).empty());
  ReferenceScene scene;
  scene.add(make_sphere(4));
  scene.rasterise();
  const SceneMesh level{&coarse, glm::mat4(1.0F), 1, &features};
  const ReferenceLines lines =
      reference_lines(std::span(&level, 1), scene.camera, scene.depth, scene.object_id);
  EXPECT_TRUE(of_class(lines, LineClass::crease).empty());
  EXPECT_FALSE(of_class(lines, LineClass::silhouette).empty());
  EXPECT_FALSE(of_class(scene.lines(), LineClass::crease).empty());
}

TEST(ReferenceShapes, same_input_gives_the_same_lines) {
  ReferenceScene scene;
  scene.camera.eye = {2, 2, 4};
  scene.add(make_torus(24, 0.3F));
  const ReferenceLines first = scene.lines();
  const ReferenceLines second = scene.lines();
  EXPECT_EQ(first.polylines, second.polylines);
  EXPECT_FALSE(first.polylines.empty());
}

}  // namespace
}  // namespace inkbench
