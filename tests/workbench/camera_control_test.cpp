// SPDX-License-Identifier: MIT
// The mouse on camera and lights: what must stay where it is stays, and nothing flips.
#include "app/workbench/camera_control.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>

#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

const ViewSize kSize{640, 480};

CameraParams paper_camera() {
  return paper_settings().camera;
}

float distance_of(const CameraParams& camera) {
  return glm::length(camera.eye - camera.target);
}

float elevation_deg(const CameraParams& camera) {
  const glm::vec3 direction = glm::normalize(camera.eye - camera.target);
  return glm::degrees(std::asin(glm::dot(direction, glm::normalize(camera.up))));
}

void expect_near(const glm::vec3& actual, const glm::vec3& expected, float tolerance = 1e-4F) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

/// Where the renderer's matrices put a point, in px from the top left.
glm::vec2 pixel_of(const CameraParams& camera, const glm::vec3& point) {
  const glm::vec4 clip = projection_matrix(camera, kSize.width_px / kSize.height_px) * view_matrix(camera) *
                         glm::vec4(point, 1.0F);
  return {(clip.x / clip.w + 1) / 2 * kSize.width_px, (1 - clip.y / clip.w) / 2 * kSize.height_px};
}

/// The point under the cursor in the plane through the target, by inverting the renderer's matrices.
glm::vec3 point_under(const CameraParams& camera, const glm::vec2& cursor_px) {
  const glm::mat4 to_clip = projection_matrix(camera, kSize.width_px / kSize.height_px) * view_matrix(camera);
  const glm::vec4 target = to_clip * glm::vec4(camera.target, 1.0F);
  const glm::vec2 ndc(2 * cursor_px.x / kSize.width_px - 1, 1 - 2 * cursor_px.y / kSize.height_px);
  const glm::vec4 point = glm::inverse(glm::dmat4(to_clip)) * glm::dvec4(ndc * target.w, target.z, target.w);
  return glm::vec3(point) / point.w;
}

CameraParams orthographic_camera() {
  CameraParams camera{.eye = {-3, 2, 5}, .target = {0, 0.5F, 0}, .up = {0, 1, 0.1F}};
  camera.projection = CameraProjection::orthographic;
  camera.view_height = 3.5F;
  return camera;
}

/// Cameras that are easy to get wrong: tilted up, up along z, from below; and an orthographic one.
std::vector<CameraParams> cameras() {
  return {paper_camera(),
          {.eye = {3, 1, -2}, .target = {0.5F, 0, 0}, .up = {0.3F, 1, -0.2F}},
          {.eye = {0, -6, -3}, .up = {0, 0, 1}, .fov = 70},
          {.eye = {4, 0, 0}, .up = {0, -1, 0}, .fov = 20},
          orthographic_camera()};
}

TEST(Orbit, keeps_target_distance_and_up) {
  for (const CameraParams& camera : cameras()) {
    const CameraParams moved = orbit(camera, 37, 11);
    EXPECT_EQ(moved.target, camera.target);
    EXPECT_EQ(moved.up, camera.up);
    EXPECT_NEAR(distance_of(moved), distance_of(camera), 1e-4F);
    EXPECT_NEAR(elevation_deg(moved), elevation_deg(camera) + 11, 1e-2F);
    EXPECT_NO_THROW(check_camera(moved));
  }
}

TEST(Orbit, goes_to_the_right_and_up) {
  const CameraParams camera;  // on +z, looking at the origin
  expect_near(orbit(camera, 90, 0).eye, {5, 0, 0});
  expect_near(orbit(camera, 180, 0).eye, {0, 0, -5});
  expect_near(orbit(camera, 0, 30).eye, {0, 2.5F, 5 * std::sqrt(3.0F) / 2});
}

TEST(Orbit, comes_back_after_a_full_turn) {
  for (const CameraParams& camera : cameras()) {
    CameraParams moved = camera;
    for (int i = 0; i < 360; ++i) moved = orbit(moved, 1, 0);
    expect_near(moved.eye, camera.eye, 1e-3F);
  }
}

TEST(Orbit, stops_at_the_poles_and_never_turns_the_picture_over) {
  for (const CameraParams& camera : cameras()) {
    for (const int way : {1, -1}) {
      CameraParams moved = camera;
      glm::vec3 right = glm::vec3(glm::transpose(view_matrix(moved))[0]);
      for (int i = 0; i < 100; ++i) {
        moved = orbit(moved, 0, way * 5);
        EXPECT_NO_THROW(check_camera(moved));
        const glm::vec3 next = glm::vec3(glm::transpose(view_matrix(moved))[0]);
        EXPECT_GT(glm::dot(right, next), 0.999F) << "the image's right side stays on the right";
        right = next;
      }
      EXPECT_NEAR(elevation_deg(moved), way * kMaxElevationDeg, 0.05);
      EXPECT_NEAR(elevation_deg(orbit(moved, 0, -way * 30)), way * (kMaxElevationDeg - 30), 0.1);
    }
  }
}

TEST(Orbit, a_camera_straight_above_can_still_be_turned) {
  CameraParams camera;
  camera.eye = {0, 5, 0};
  const CameraParams moved = orbit(camera, 10, -20);
  EXPECT_NO_THROW(check_camera(moved));
  EXPECT_NEAR(elevation_deg(moved), 70, 1e-3F);
}

TEST(Orbit, a_drag_moves_the_scene_with_the_cursor) {
  for (const CameraParams& camera : cameras()) {
    // A point nearer than the target: it must go the cursor's way.
    const glm::vec3 front = camera.target + 0.2F * (camera.eye - camera.target);
    const glm::vec2 before = pixel_of(camera, front);
    EXPECT_GT(pixel_of(orbit_drag(camera, {300, 200}, {340, 200}, kSize), front).x, before.x + 1);
    EXPECT_GT(pixel_of(orbit_drag(camera, {300, 200}, {300, 240}, kSize), front).y, before.y + 1);
  }
}

TEST(Pan, keeps_what_is_under_the_cursor_there) {
  for (const CameraParams& camera : cameras()) {
    for (const auto& [from, to] :
         {std::pair{glm::vec2(320, 240), glm::vec2(400, 100)}, {glm::vec2(10, 470), glm::vec2(630, 5)}}) {
      const glm::vec3 grabbed = point_under(camera, from);
      const CameraParams moved = pan(camera, from, to, kSize);
      EXPECT_NEAR(pixel_of(moved, grabbed).x, to.x, 0.01F);
      EXPECT_NEAR(pixel_of(moved, grabbed).y, to.y, 0.01F);
      expect_near(moved.eye - moved.target, camera.eye - camera.target);
    }
  }
}

TEST(Dolly, goes_a_tenth_of_the_distance_each_step_and_back) {
  const CameraParams camera = paper_camera();
  EXPECT_NEAR(distance_of(dolly(camera, 1)), 0.9F * distance_of(camera), 1e-4F);
  EXPECT_EQ(dolly(camera, 1).target, camera.target);
  expect_near(dolly(dolly(camera, 3.5), -3.5).eye, camera.eye);
}

TEST(Dolly, keeps_the_target_between_near_and_far_which_stay) {
  for (const double steps : {1000.0, -1000.0}) {
    const CameraParams moved = dolly(paper_camera(), steps);
    EXPECT_EQ(moved.near, paper_camera().near);
    EXPECT_EQ(moved.far, paper_camera().far);
    EXPECT_GE(distance_of(moved), 2 * moved.near * 0.999F);
    EXPECT_LE(distance_of(moved), 0.951F * moved.far);
    EXPECT_NO_THROW(check_camera(moved));
  }
}

TEST(Dolly, a_camera_out_of_range_is_not_pulled_by_a_jump) {
  CameraParams camera;
  camera.far = 4;  // the target at 5 is behind it
  EXPECT_EQ(distance_of(dolly(camera, -1)), 5.0F);
  EXPECT_NEAR(distance_of(dolly(camera, 1)), 4.5F, 1e-5F);
}

TEST(DollyAt, keeps_what_is_under_the_cursor_there) {
  for (const CameraParams& camera : cameras()) {
    const glm::vec2 cursor(100, 400);
    const glm::vec3 aimed = point_under(camera, cursor);
    for (const double steps : {1.0, 4.0, -3.0}) {
      const CameraParams moved = dolly_at(camera, steps, cursor, kSize);
      EXPECT_NEAR(pixel_of(moved, aimed).x, cursor.x, 0.02F);
      EXPECT_NEAR(pixel_of(moved, aimed).y, cursor.y, 0.02F);
      EXPECT_NE(moved.eye, camera.eye);
    }
  }
}

TEST(DollyAt, an_orthographic_view_shows_less_and_its_eye_keeps_its_distance) {
  const CameraParams camera = orthographic_camera();
  const CameraParams moved = dolly_at(camera, 3, {100, 400}, kSize);
  EXPECT_NEAR(moved.view_height, camera.view_height * std::pow(0.9F, 3), 1e-5F);
  expect_near(moved.eye - moved.target, camera.eye - camera.target);
  EXPECT_EQ(dolly(camera, 3).eye, camera.eye);
}

TEST(WithProjection, what_is_at_the_target_keeps_place_and_size) {
  for (const CameraParams& camera : cameras()) {
    const auto other =
        is_orthographic(camera) ? CameraProjection::perspective : CameraProjection::orthographic;
    const CameraParams turned = with_projection(camera, other);
    EXPECT_EQ(turned.projection, other);
    EXPECT_EQ(turned.target, camera.target);
    for (const glm::vec2 cursor : {glm::vec2(320, 240), glm::vec2(10, 470), glm::vec2(600, 30)}) {
      const glm::vec3 point = point_under(camera, cursor);
      EXPECT_NEAR(pixel_of(turned, point).x, cursor.x, 0.01F);
      EXPECT_NEAR(pixel_of(turned, point).y, cursor.y, 0.01F);
    }
    const CameraParams back = with_projection(turned, camera.projection);
    EXPECT_EQ(back.projection, camera.projection);
    expect_near(back.eye - back.target, turned.eye - turned.target);
    EXPECT_NO_THROW(check_camera(turned));
  }
}

TEST(WithProjection, a_perspective_view_that_shows_much_or_little_keeps_the_target_between_its_planes) {
  for (const float height : {1e-3F, 1e3F}) {
    CameraParams camera = orthographic_camera();
    camera.view_height = height;
    const CameraParams turned = with_projection(camera, CameraProjection::perspective);
    EXPECT_NEAR(seen_height(turned, distance_of(turned)) / height, 1.0, 1e-3);
    EXPECT_LT(turned.near, distance_of(turned));
    EXPECT_GT(turned.far, distance_of(turned));
  }
}

TEST(LookAround, turns_about_the_eye) {
  const CameraParams camera;
  const CameraParams right = look_around(camera, 90, 0);
  EXPECT_EQ(right.eye, camera.eye);
  expect_near(right.target, {5, 0, 5});
  EXPECT_GT(look_around(camera, 0, 10).target.y, 0.5F);
  for (const CameraParams& any : cameras()) {
    EXPECT_NEAR(distance_of(look_around(any, 200, -500)), distance_of(any), 1e-4F);
    EXPECT_NO_THROW(check_camera(look_around(any, 200, -500)));
    // What was in the middle goes left when the view goes right, and down when it goes up.
    EXPECT_LT(pixel_of(look_around(any, 5, 0), any.target).x, kSize.width_px / 2 - 1);
    EXPECT_GT(pixel_of(look_around(any, 0, 5), any.target).y, kSize.height_px / 2 + 1);
  }
}

TEST(ViewFrom, gives_the_standard_views) {
  CameraParams camera = paper_camera();
  const float distance = distance_of(camera);
  expect_near(view_from(camera, 0, 0).eye, camera.target + glm::vec3(0, 0, distance));
  expect_near(view_from(camera, 90, 0).eye, camera.target + glm::vec3(distance, 0, 0));
  expect_near(view_from(camera, 180, 0).eye, camera.target - glm::vec3(0, 0, distance));
  expect_near(view_from(camera, 0, 90).eye, camera.target + glm::vec3(0, distance, 0), 0.05F);
  EXPECT_NO_THROW(check_camera(view_from(camera, 0, 90)));
}

TEST(FitToBounds, shows_the_whole_box_between_near_and_far) {
  for (const CameraParams& camera : cameras()) {
    for (const float scale : {0.01F, 1.0F, 300.0F}) {
      const Bounds bounds{glm::vec3(-1, 0, -2) * scale, glm::vec3(3, 1, 0.5F) * scale};
      const CameraParams fitted = fit_to_bounds(camera, bounds, kSize);
      EXPECT_NO_THROW(check_camera(fitted));
      float widest = 0;
      for (int i = 0; i < 8; ++i) {
        const glm::vec3 corner((i & 1) != 0 ? bounds.high.x : bounds.low.x,
                               (i & 2) != 0 ? bounds.high.y : bounds.low.y,
                               (i & 4) != 0 ? bounds.high.z : bounds.low.z);
        const glm::vec4 clip = projection_matrix(fitted, kSize.width_px / kSize.height_px) *
                               view_matrix(fitted) * glm::vec4(corner, 1.0F);
        for (int c = 0; c < 3; ++c) EXPECT_LT(std::abs(clip[c]), clip.w) << scale << " " << c;
        widest = std::max({widest, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
      }
      EXPECT_NEAR(widest, 0.95F, 0.01F) << "it fills the image";
    }
  }
}

TEST(FitToBounds, an_empty_box_is_looked_at_from_a_sensible_distance) {
  const CameraParams fitted = fit_to_bounds(paper_camera(), {glm::vec3(2), glm::vec3(2)}, kSize);
  EXPECT_EQ(fitted.target, glm::vec3(2));
  EXPECT_GT(distance_of(fitted), 1.0F);
  EXPECT_NO_THROW(check_camera(fitted));
}

TEST(KeepInRange, changes_nothing_where_all_fits) {
  const CameraParams kept = keep_in_range(paper_camera(), {glm::vec3(-1), glm::vec3(1)});
  EXPECT_EQ(kept.near, paper_camera().near);
  EXPECT_EQ(kept.far, paper_camera().far);
}

TEST(KeepInRange, widens_only_the_end_that_cuts) {
  const CameraParams camera{.eye = {0, 0, 5}, .near = 1, .far = 10};
  const CameraParams deep = keep_in_range(camera, {glm::vec3(-1, -1, -100), glm::vec3(1)});
  EXPECT_EQ(deep.near, 1.0F);
  EXPECT_FLOAT_EQ(deep.far, 120);  // 105 and a tenth, up to two digits
  const CameraParams close = keep_in_range(camera, {glm::vec3(-1), glm::vec3(1, 1, 4.5F)});
  EXPECT_FLOAT_EQ(close.near, 0.25F);
  EXPECT_EQ(close.far, 10.0F);
  EXPECT_NO_THROW(check_camera(keep_in_range(camera, {glm::vec3(-500), glm::vec3(500)})));
}

TEST(KeepInRange, an_orthographic_eye_steps_back_until_the_box_is_before_it) {
  CameraParams camera{.eye = {0, 0, 5}, .near = 1, .far = 10};
  camera.projection = CameraProjection::orthographic;
  const CameraParams kept = keep_in_range(camera, {glm::vec3(-1), glm::vec3(1, 1, 20)});
  expect_near(kept.eye, {0, 0, 22});
  EXPECT_EQ(kept.near, 1.0F);
  EXPECT_FLOAT_EQ(kept.far, 26);  // 23 and a tenth, up to two digits
  EXPECT_EQ(kept.view_height, camera.view_height);
}

TEST(CameraControl, never_leaves_the_parameters_limits) {
  CameraParams camera = paper_camera();
  camera.far = 1e6F;
  CameraParams orthographic = orthographic_camera();
  orthographic.view_height = 1e6F;
  for (const CameraParams& moved :
       {pan(camera, {0, 0}, {1e9F, 0}, kSize), dolly(camera, -1e6), dolly_at(camera, -1e6, {1e6F, 0}, kSize),
        dolly(orthographic, -1), dolly(orthographic, 1e6),
        with_projection(orthographic, CameraProjection::perspective),
        fit_to_bounds(orthographic, {glm::vec3(-1e8F), glm::vec3(1e8F)}, kSize),
        fit_to_bounds(camera, {glm::vec3(-1e8F), glm::vec3(1e8F)}, kSize), orbit(camera, std::nan(""), 0),
        pan(camera, {0, 0}, {std::nanf(""), 0}, kSize), pan(camera, {0, 0}, {5, 5}, {0, 0})}) {
    Settings settings = paper_settings();
    settings.camera = moved;
    for (const Param& param : list_params(settings)) EXPECT_NO_THROW(param.set(param.value(), "test"));
    EXPECT_NO_THROW(check_camera(moved));
  }
}

TEST(DragLight, moves_the_light_with_the_cursor) {
  for (const CameraParams& camera : cameras()) {
    const glm::vec3 to_eye = glm::normalize(camera.eye - camera.target);
    const auto seen = [&](const glm::vec3& direction) {
      return glm::vec3(view_matrix(camera) * glm::vec4(direction, 0.0F));
    };
    const glm::vec3 right = drag_light(to_eye, camera, {320, 240}, {420, 240}, kSize);
    EXPECT_GT(seen(right).x, 0.3F);
    EXPECT_NEAR(seen(right).y, 0, 1e-4F);
    const glm::vec3 down = drag_light(to_eye, camera, {320, 240}, {320, 340}, kSize);
    EXPECT_LT(seen(down).y, -0.3F);
  }
}

TEST(DragLight, back_to_the_start_gives_the_start) {
  const glm::vec3 direction = glm::normalize(glm::vec3(0.55F, 0.75F, 0.65F));
  const glm::vec2 a(100, 100);
  const glm::vec2 b(500, 300);
  const glm::vec3 there = drag_light(direction, paper_camera(), a, b, kSize);
  EXPECT_NEAR(glm::length(there), 1.0F, 1e-6F);
  expect_near(drag_light(there, paper_camera(), b, a, kSize), direction);
  expect_near(drag_light(direction, paper_camera(), a, a, kSize), direction);
}

TEST(DragLight, does_not_jump_at_the_balls_rim) {
  glm::vec3 last = drag_light({0, 0, 1}, paper_camera(), {320, 240}, {320, 240}, kSize);
  for (int x = 321; x < 640; ++x) {
    const glm::vec3 next =
        drag_light({0, 0, 1}, paper_camera(), {320, 240}, {static_cast<float>(x), 240}, kSize);
    EXPECT_LT(glm::length(next - last), 0.02F) << x;
    last = next;
  }
}

TEST(DragLight, gives_a_direction_that_settings_accept) {
  for (const glm::vec3& direction : {glm::vec3(0), glm::vec3(1), glm::vec3(1e-3F, 0, 0)}) {
    Settings settings = paper_settings();
    set(settings, "light.key.direction", drag_light(direction, paper_camera(), {0, 0}, {640, 480}, kSize));
    EXPECT_NO_THROW(check_settings(settings));
  }
}

}  // namespace
}  // namespace inkbench
