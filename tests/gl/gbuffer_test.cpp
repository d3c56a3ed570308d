// SPDX-License-Identifier: MIT
// The G-buffer against exact rays through the pixels' centres (3.4.1, 3.4.2).
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "pipeline/base/log.h"
#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/cpu_rays.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

// Both ways around, the tessellated sphere lies up to 8e-5 inside the exact one. 1 px inside its outline the
// ray goes 4 times further until it meets it; depth is divided by far = 20. Normals turn by as much, at half
// scale.
constexpr double kDepthTolerance = 4e-5;
constexpr double kNormalTolerance = 3e-4;

void expect_rays(const Settings& settings) {
  Pipeline pipeline;
  const reference::Surface expected = reference::cast_rays(settings);
  const ImageOf<uint8_t> outlines = reference::outlines(expected);
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::object_id), expected.object_id, 0.0, &outlines));
  EXPECT_TRUE(
      is_near(pipeline.at(settings).raw(BufferName::depth), expected.depth, kDepthTolerance, &outlines));
  EXPECT_TRUE(
      is_near(pipeline.at(settings).raw(BufferName::normal), expected.normal, kNormalTolerance, &outlines));
  EXPECT_LT(share_of(outlines), 0.2);
}

TEST(GBuffer, equals_rays_on_floor_sphere_and_box) {
  expect_rays(analytic_scene());
}

TEST(GBuffer, equals_rays_in_tall_and_wide_images) {
  Settings settings = analytic_scene();
  settings.image.width = 61;
  settings.image.height = 150;
  expect_rays(settings);
  settings.image.width = 200;
  settings.image.height = 41;
  expect_rays(settings);
}

TEST(GBuffer, equals_rays_inside_an_inside_out_sphere) {
  Settings settings = analytic_scene();
  settings.models.push_back({.name = "room",
                             .shape = Shape::inside_out_sphere,
                             .segments = 128,
                             .size = 20.0F,
                             .position = {0.0F, 1.0F, 0.0F}});
  // The room's radius is 10: its tessellation is 10 times further off than the ball's.
  Pipeline pipeline;
  const reference::Surface expected = reference::cast_rays(settings);
  const ImageOf<uint8_t> outlines = reference::outlines(expected);
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::object_id), expected.object_id, 0.0, &outlines));
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::depth), expected.depth, 10.0 * kDepthTolerance,
                      &outlines));
  EXPECT_TRUE(
      is_near(pipeline.at(settings).raw(BufferName::normal), expected.normal, kNormalTolerance, &outlines));
}

TEST(GBuffer, normals_of_a_stretched_sphere_stay_perpendicular) {
  Settings settings = analytic_scene();
  settings.models = {settings.models[1]};
  settings.models[0].scale = {1.0F, 0.4F, 1.6F};
  settings.models[0].rotation = {15.0F, 40.0F, -25.0F};
  settings.models[0].anchor = Anchor::origin;
  // Stretched by 0.4 the ellipsoid bends up to 1.6^2 / 0.4 times more than the sphere that the tolerance is
  // for.
  Pipeline pipeline;
  const reference::Surface expected = reference::cast_rays(settings);
  const ImageOf<uint8_t> outlines = reference::outlines(expected);
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::depth), expected.depth, 4.0 * kDepthTolerance,
                      &outlines));
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::normal), expected.normal, 6.0 * kNormalTolerance,
                      &outlines));
}

TEST(GBuffer, shows_the_inside_of_closed_shapes_to_an_eye_inside) {
  Settings settings = analytic_scene();
  settings.models = {settings.models[1], settings.models[2]};
  settings.models[0].size = 16.0F;  // around everything
  settings.models[0].anchor = Anchor::origin;
  Pipeline pipeline;
  const reference::Surface expected = reference::cast_rays(settings);
  const ImageOf<uint8_t> outlines = reference::outlines(expected);
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::object_id), expected.object_id, 0.0, &outlines));
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::depth), expected.depth, 8.0 * kDepthTolerance,
                      &outlines));
  EXPECT_TRUE(
      is_near(pipeline.at(settings).raw(BufferName::normal), expected.normal, kNormalTolerance, &outlines));
}

TEST(GBuffer, shows_the_inside_of_shapes_that_the_near_plane_cuts) {
  Settings settings = analytic_scene();
  for (const float near : {5.0F, 5.5F, 6.0F, 6.5F, 7.0F}) {
    settings.camera.near = near;
    expect_rays(settings);
  }
}

Settings orthographic_scene() {
  Settings settings = analytic_scene();
  settings.camera.projection = CameraProjection::orthographic;
  settings.camera.view_height = 4.5F;
  return settings;
}

TEST(GBuffer, equals_rays_in_orthographic_views_of_any_shape) {
  Settings settings = orthographic_scene();
  expect_rays(settings);
  settings.image.width = 61;
  settings.image.height = 150;
  expect_rays(settings);
}

TEST(GBuffer, shows_the_inside_of_shapes_that_an_orthographic_view_cuts) {
  Settings settings = orthographic_scene();
  for (const float near : {4.0F, 5.5F, 6.5F, 7.5F}) {
    settings.camera.near = near;
    expect_rays(settings);
  }
}

TEST(GBuffer, depth_of_a_slanted_plane_is_exact_in_orthographic_views_whatever_the_planes) {
  Settings settings = orthographic_scene();
  settings.models = {settings.models[0]};
  settings.models[0].size = 100.0F;
  for (const auto& [near, far] : {std::pair{0.1F, 20.0F}, {0.01F, 1000.0F}, {1.0F, 30.0F}}) {
    settings.camera.near = near;
    settings.camera.far = far;
    Pipeline pipeline;
    const Image depth = pipeline.at(settings).raw(BufferName::depth);
    double worst = 0.0;
    for (int y = 0; y < depth.height_px; ++y) {
      for (int x = 0; x < depth.width_px; ++x) {
        const glm::dvec3 eye = reference::pixel_eye(settings.camera, x, y, depth.width_px, depth.height_px);
        const glm::dvec3 ray = reference::pixel_ray(settings.camera, x, y, depth.width_px, depth.height_px);
        worst = std::max(worst, std::abs(double{depth.at(x, y)} * far + eye.y / ray.y));
      }
    }
    EXPECT_LT(worst, 2e-5) << "world units, near " << near << ", far " << far;
  }
}

TEST(GBuffer, a_scene_of_another_size_is_drawn_to_the_bit_as_it_was) {
  for (const CameraProjection projection : {CameraProjection::perspective, CameraProjection::orthographic}) {
    Settings settings = orthographic_scene();
    settings.camera.projection = projection;
    settings.models[1].two_sided = false;
    Pipeline pipeline;
    const auto all_maps = [&](const Settings& scene) {
      std::vector<Image> maps;
      for (const BufferName buffer : framebuffers()) maps.push_back(pipeline.at(scene).raw(buffer));
      return maps;
    };
    const std::vector<Image> before = all_maps(settings);
    for (const float scale : {0.0009765625F, 1024.0F}) {  // powers of two, which floats hold exactly
      const std::vector<Image> after = all_maps(scaled_scene(settings, scale));
      for (size_t i = 0; i < before.size(); ++i)
        EXPECT_EQ(before[i].samples, after[i].samples) << scale << " " << name_of(framebuffers()[i]);
    }
  }
}

TEST(GBuffer, depth_is_the_papers_linearisation_over_far) {
  // A wall facing the camera 4 units away: z of 3.4.2 is the same in all pixels, whatever the angle of the
  // ray.
  Settings settings;
  settings.image.width = settings.image.height = 32;
  settings.camera = {{0.0F, 0.0F, 4.0F}, {0.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, 60.0F, 0.5F, 8.0F};
  ModelParams wall{.name = "wall", .shape = Shape::plane, .segments = 1, .size = 20.0F};
  wall.rotation.x = 90.0F;
  settings.models = {wall};
  const double near = 0.5;
  const double far = 8.0;
  const double z_ndc = (far + near) / (far - near) - 2.0 * far * near / ((far - near) * 4.0);
  const double linear = 2.0 * near * far / (near + far - z_ndc * (far - near));
  Pipeline pipeline;
  for (const float depth : pipeline.at(settings).raw(BufferName::depth).samples)
    ASSERT_NEAR(depth, linear / far, 1e-6);
}

TEST(GBuffer, near_plane_does_not_change_depth) {
  Settings settings = analytic_scene();
  Pipeline pipeline;
  const Image before = pipeline.at(settings).raw(BufferName::depth);
  settings.camera.near = 1.0F;
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::depth), before, 1e-6));
}

TEST(GBuffer, background_is_far_and_without_normal_and_object) {
  Settings settings = small_scene();
  settings.models.clear();
  settings.scene.background = {0.9F, 0.2F, 0.3F};
  Pipeline pipeline;
  EXPECT_EQ(largest_difference(pipeline.at(settings).raw(BufferName::depth), Image(48, 40, 1, 1.0F)), 0.0);
  EXPECT_EQ(largest_difference(pipeline.at(settings).raw(BufferName::normal), Image(48, 40, 3, 0.5F)), 0.0);
  EXPECT_EQ(largest_difference(pipeline.at(settings).raw(BufferName::object_id), Image(48, 40, 1, 0.0F)),
            0.0);
  for (const BufferName buffer : {BufferName::shaded, BufferName::final, BufferName::blinn_phong}) {
    const Image image = pipeline.at(settings).raw(buffer);
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(image.at(20, 20, c), settings.scene.background[c]) << name_of(buffer);
  }
}

TEST(GBuffer, object_ids_are_exact_and_keep_the_scenes_order) {
  Settings settings = analytic_scene();
  Pipeline pipeline;
  const auto ids_in = [&] {
    std::set<float> ids;
    for (const float id : pipeline.at(settings).raw(BufferName::object_id).samples) ids.insert(id);
    return ids;
  };
  EXPECT_EQ(ids_in(), (std::set<float>{0.0F, 1.0F, 2.0F, 3.0F}));
  settings.models[1].visible = false;
  EXPECT_EQ(ids_in(), (std::set<float>{0.0F, 1.0F, 3.0F}));
}

TEST(GBuffer, nearer_surfaces_hide_farther_ones_in_any_order) {
  Settings settings = analytic_scene();
  Pipeline pipeline;
  const Image depth = pipeline.at(settings).raw(BufferName::depth);
  std::reverse(settings.models.begin(), settings.models.end());
  EXPECT_EQ(largest_difference(pipeline.at(settings).raw(BufferName::depth), depth), 0.0);
}

void expect_told_once(Settings settings) {
  std::vector<std::string> notes;
  const LogSink before = set_log_sink([&](const std::string& note) { notes.push_back(note); });
  Pipeline pipeline;
  pipeline.at(settings).raw(BufferName::depth);
  EXPECT_TRUE(notes.empty());
  settings.models[1].position += 100.0F * (settings.camera.target - settings.camera.eye);
  pipeline.at(settings).raw(BufferName::depth);
  settings.camera.fov += 1.0F;
  settings.camera.view_height += 1.0F;
  pipeline.at(settings).raw(BufferName::depth);
  set_log_sink(before);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].substr(0, notes[0].find(" lies")), "model '" + settings.models[1].name + "'");
}

TEST(GBuffer, a_model_beyond_the_far_plane_is_told_once) {
  expect_told_once(analytic_scene());
  expect_told_once(orthographic_scene());
}

TEST(GBuffer, a_face_seen_from_behind_takes_the_opposite_normal_where_it_is_two_sided) {
  Settings settings = analytic_scene();
  settings.models = {ModelParams{.name = "sheet", .shape = Shape::plane, .segments = 1, .size = 100.0F}};
  settings.camera.eye = {0.0F, -3.0F, 4.0F};  // from below
  settings.camera.target = {0.0F, 0.0F, 0.0F};
  for (const bool two_sided : {true, false}) {
    settings.models[0].two_sided = two_sided;
    Pipeline pipeline;
    const Image normal = pipeline.at(settings).raw(BufferName::normal);
    EXPECT_FLOAT_EQ(normal.at(normal.width_px / 2, normal.height_px / 2, 1), two_sided ? 0.0F : 1.0F);
  }
}

}  // namespace
}  // namespace inkbench
