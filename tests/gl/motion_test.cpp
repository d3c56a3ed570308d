// SPDX-License-Identifier: MIT
// Motion against points that are carried by hand: out of the pixel's ray and its depth, with the models, into
// the other camera's picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/matrix.hpp>

#include "pipeline/passes/gbuffer/motion.h"
#include "pipeline/pipeline.h"
#include "pipeline/settings/camera_path.h"
#include "tests/gl/checks.h"
#include "tests/gl/cpu_rays.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

constexpr double kMotionSlackPx = 0.005;

/// The settings a few degrees later, with the box moved by itself.
Settings later(Settings settings) {
  settings.camera = camera_at({.frames = 60, .axis = {0.2F, 1.0F, 0.1F}, .degrees = 360}, settings.camera, 1);
  settings.models[2].position.y += 0.2F;
  settings.models[2].rotation.z += 15.0F;
  return settings;
}

glm::dmat4 place_of_model(Pipeline& pipeline, const Settings& settings, int id) {
  for (const DrawItem& item : pipeline.at(settings).draw_items()) {
    if (item.object_id == id) return glm::dmat4(item.model_to_world);
  }
  ADD_FAILURE() << "no model " << id;
  return glm::dmat4(1.0);
}

Image motion_between(Pipeline& pipeline, const Settings& here, const Settings& other) {
  return pipeline.at(here, pipeline.at(other)).value<MotionPass>()->read(0, 4);
}

/// The whole map, by hand.
Image expected_motion(Pipeline& pipeline, const Settings& here, const Settings& other) {
  const Image depth = pipeline.at(here).raw(BufferName::depth);
  const Image ids = pipeline.at(here).raw(BufferName::object_id);
  std::vector<glm::dmat4> moves{glm::dmat4(1.0)};
  for (int id = 1; id <= static_cast<int>(here.models.size()); ++id)
    moves.push_back(place_of_model(pipeline, other, id) * glm::inverse(place_of_model(pipeline, here, id)));
  Image expected(depth.width_px, depth.height_px, 4, 0.0F);
  for (int y = 0; y < depth.height_px; ++y) {
    for (int x = 0; x < depth.width_px; ++x) {
      const auto id = static_cast<size_t>(ids.at(x, y));
      if (id == 0) continue;
      const glm::dvec3 ray = reference::pixel_ray(here.camera, x, y, depth.width_px, depth.height_px);
      const glm::dvec3 world = glm::dvec3(here.camera.eye) + ray * (double{depth.at(x, y)} * here.camera.far);
      const glm::dvec3 there = reference::seen_at(other, glm::dvec3(moves[id] * glm::dvec4(world, 1.0)));
      expected.at(x, y, 0) = static_cast<float>(there.x - (x + 0.5));
      expected.at(x, y, 1) = static_cast<float>(there.y - (y + 0.5));
      expected.at(x, y, 2) = static_cast<float>(there.z);
      expected.at(x, y, 3) = 1.0F;
    }
  }
  return expected;
}

TEST(Motion, carries_points_as_camera_and_models_move) {
  Pipeline pipeline;
  const Settings before = analytic_scene(), now = later(before);
  const Image motion = motion_between(pipeline, now, before);
  EXPECT_TRUE(is_near(motion, expected_motion(pipeline, now, before), kMotionSlackPx));
  EXPECT_GT(largest_difference(motion, Image(motion.width_px, motion.height_px, 4, 0.0F)), 5) << "it moves";
}

TEST(Motion, looks_ahead_where_the_later_frame_is_given_as_the_past) {
  Pipeline pipeline;
  const Settings before = analytic_scene(), now = later(before);
  EXPECT_TRUE(
      is_near(motion_between(pipeline, before, now), expected_motion(pipeline, before, now), kMotionSlackPx));
}

TEST(Motion, sizes_and_fields_of_view_may_differ) {
  Pipeline pipeline;
  const Settings now = analytic_scene();
  Settings before = later(now);
  before.image.width = 90;
  before.image.height = 140;
  before.camera.fov = 55;
  EXPECT_TRUE(
      is_near(motion_between(pipeline, now, before), expected_motion(pipeline, now, before), kMotionSlackPx));
}

TEST(Motion, is_nothing_without_a_frame_before) {
  Pipeline pipeline;
  const Image motion = pipeline.at(analytic_scene()).value<MotionPass>()->read(0, 4);
  EXPECT_TRUE(is_near(motion, Image(motion.width_px, motion.height_px, 4, 0.0F), 0.0));
  const Picture picture = pipeline.at(analytic_scene()).picture(BufferName::motion);
  EXPECT_NEAR(picture.at(3, 3, 0), 127, 1);
  EXPECT_NEAR(picture.at(3, 3, 1), 127, 1);
}

TEST(Motion, is_shown_as_red_and_green_about_grey) {
  Pipeline pipeline;
  const Settings before = analytic_scene();
  const Frame frame = pipeline.at(later(before), pipeline.at(before));
  const Image raw = frame.raw(BufferName::motion);
  const Picture picture = frame.picture(BufferName::motion);
  for (int y = 0; y < raw.height_px; ++y) {
    for (int x = 0; x < raw.width_px; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double value = 0.5 + (c < 2 ? raw.at(x, y, c) / 64.0 : 0.0);
        ASSERT_NEAR(picture.at(x, y, c), 255.0 * std::clamp(value, 0.0, 1.0), 0.51) << x << ", " << y;
      }
    }
  }
}

TEST(Motion, a_still_camera_moves_nothing) {
  Pipeline pipeline;
  Settings settings = analytic_scene();
  settings.camera.near = 0.2F;  // another key, the same places
  const Image raw = pipeline.at(settings, pipeline.at(analytic_scene())).raw(BufferName::motion);
  EXPECT_EQ(raw.channels, 2);
  EXPECT_TRUE(is_near(raw, Image(raw.width_px, raw.height_px, 2, 0.0F), 1.0 / 512))
      << "less than half a 256th";
}

/// How many pixels have a place in the other frame, of those of each id.
std::vector<int> placed_pixels(Pipeline& pipeline, const Settings& here, const Settings& other) {
  const Image motion = motion_between(pipeline, here, other);
  const Image ids = pipeline.at(here).raw(BufferName::object_id);
  std::vector<int> count(here.models.size() + 1, 0);
  for (int y = 0; y < ids.height_px; ++y) {
    for (int x = 0; x < ids.width_px; ++x)
      count[static_cast<size_t>(ids.at(x, y))] += motion.at(x, y, 3) > 0 ? 1 : 0;
  }
  return count;
}

TEST(Motion, a_model_that_is_not_there_or_has_another_mesh_has_none) {
  Pipeline pipeline;
  const Settings here = analytic_scene();
  Settings other = here;
  other.models[1].visible = false;
  other.models[2].segments = 2;
  const std::vector<int> count = placed_pixels(pipeline, here, other);
  EXPECT_GT(count[1], 1000);
  EXPECT_EQ(count[2], 0);
  EXPECT_EQ(count[3], 0);
}

TEST(Motion, points_outside_the_planes_of_the_other_camera_have_none) {
  Pipeline pipeline;
  const Settings here = analytic_scene();
  Settings close = here;
  close.camera.near = 19.0F;
  EXPECT_EQ(placed_pixels(pipeline, here, close), std::vector<int>(4, 0));
  Settings turned_away = here;
  turned_away.camera.target = 2.0F * here.camera.eye - here.camera.target;
  EXPECT_EQ(placed_pixels(pipeline, here, turned_away), std::vector<int>(4, 0)) << "they are behind the eye";
}

TEST(Motion, knows_more_models_than_one_go_takes) {
  Settings here = small_scene();
  here.models.clear();
  for (int i = 0; i < 150; ++i) {
    here.models.push_back({.name = "box" + std::to_string(i),
                           .shape = Shape::box,
                           .segments = 1,
                           .size = 0.2F,
                           .position = {(i % 15) * 0.25F - 1.75F, (i / 15) * 0.25F - 1.1F, 0.0F}});
  }
  Settings before = here;
  for (size_t i = 0; i < before.models.size(); ++i)
    before.models[i].position.x += 0.01F * static_cast<float>(i);
  Pipeline pipeline;
  EXPECT_TRUE(is_near(motion_between(pipeline, here, before), expected_motion(pipeline, here, before),
                      kMotionSlackPx));
}

}  // namespace
}  // namespace inkbench
