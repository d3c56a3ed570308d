// SPDX-License-Identifier: MIT
// Light against the equations of 3.1 and 3.2 at the pixels' centres.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "pipeline/image/image_file.h"
#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/cpu_rays.h"
#include "tests/gl/cpu_shading.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

// From exact rays to the tessellated sphere N turns by up to 6e-4, and (N.H)^40 changes by up to 4 times
// that.
constexpr double kTessellation = 3e-3;
// From the same G-buffer: float arithmetic, most of it in the power, plus half a texel of a smooth ramp's
// table.
constexpr double kArithmetic = 5e-4;

void mark(ImageOf<uint8_t>& mask, const ImageOf<uint8_t>& more) {
  for (size_t i = 0; i < mask.samples.size(); ++i) mask.samples[i] |= more.samples[i];
}

/// From the pipeline's own G-buffer, so that only the light is compared.
reference::Shading shade_read_back(Pipeline& pipeline, const Settings& settings, bool use_ramps) {
  return reference::shade(settings, reference::to_map(pipeline.at(settings).raw(BufferName::normal)),
                          reference::to_map(pipeline.at(settings).raw(BufferName::depth)),
                          reference::to_map(pipeline.at(settings).raw(BufferName::object_id)), use_ramps);
}

void expect_shaded(const Settings& settings) {
  Pipeline pipeline;
  const reference::Shading plain = shade_read_back(pipeline, settings, false);
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::blinn_phong), plain.colour, kArithmetic));
  const reference::Shading ramped = shade_read_back(pipeline, settings, settings.ramp.enabled);
  EXPECT_TRUE(
      is_near(pipeline.at(settings).raw(BufferName::shaded), ramped.colour, kArithmetic, &ramped.at_step));
  EXPECT_LT(share_of(ramped.at_step), 0.1);
}

TEST(Shade, plain_light_equals_rays_on_floor_sphere_and_box) {
  const Settings settings = analytic_scene();
  const reference::Surface surface = reference::cast_rays(settings);
  const ImageOf<uint8_t> outlines = reference::outlines(surface);
  const reference::Shading expected =
      reference::shade(settings, surface.normal, surface.depth, surface.object_id, false);
  Pipeline pipeline;
  EXPECT_TRUE(
      is_near(pipeline.at(settings).raw(BufferName::blinn_phong), expected.colour, kTessellation, &outlines));
}

TEST(Shade, ramped_light_equals_rays_away_from_steps) {
  const Settings settings = analytic_scene();
  const reference::Surface surface = reference::cast_rays(settings);
  ImageOf<uint8_t> leave_out = reference::outlines(surface);
  const reference::Shading expected =
      reference::shade(settings, surface.normal, surface.depth, surface.object_id, true);
  mark(leave_out, expected.at_step);
  EXPECT_LT(share_of(leave_out), 0.25);
  Pipeline pipeline;
  EXPECT_TRUE(
      is_near(pipeline.at(settings).raw(BufferName::shaded), expected.colour, kTessellation, &leave_out));
}

TEST(Shade, sums_directional_and_point_lights) {
  expect_shaded(analytic_scene());
}

TEST(Shade, equals_reference_in_orthographic_views) {
  Settings settings = analytic_scene();
  settings.camera.projection = CameraProjection::orthographic;
  expect_shaded(settings);
}

TEST(Shade, the_sun_lights_all_of_a_plane_alike_in_an_orthographic_view) {
  // Its highlight, too, since the way to the eye is the same everywhere.
  Settings settings = analytic_scene();
  settings.camera.projection = CameraProjection::orthographic;
  settings.camera.view_height = 1.0F;
  settings.models = {settings.models[0]};
  settings.models[0].size = 50.0F;
  settings.models[0].material.specular = 0.5F;
  settings.lights = {settings.lights[0]};
  settings.ramp.enabled = false;
  const auto spread = [&] {
    const Image shaded = Pipeline().at(settings).raw(BufferName::shaded);
    double least = shaded.at(0, 0, 1), most = least;
    for (int y = 0; y < shaded.height_px; ++y) {
      for (int x = 0; x < shaded.width_px; ++x) {
        least = std::min<double>(least, shaded.at(x, y, 1));
        most = std::max<double>(most, shaded.at(x, y, 1));
      }
    }
    return most - least;
  };
  EXPECT_LT(spread(), 1e-6);
  settings.camera.projection = CameraProjection::perspective;
  settings.camera.fov = 8.0F;
  EXPECT_GT(spread(), 1e-3);
}

TEST(Shade, equals_reference_with_each_light_alone) {
  for (size_t kept = 0; kept < 2; ++kept) {
    Settings settings = analytic_scene();
    settings.lights = {settings.lights[kept]};
    expect_shaded(settings);
  }
}

TEST(Shade, equals_reference_with_many_lights) {
  Settings settings = analytic_scene();
  for (int i = 0; i < 6; ++i) {
    LightParams light = settings.lights[i % 2];
    light.name = "extra" + std::to_string(i);
    light.position.x += static_cast<float>(i);
    light.direction.z -= 0.2F * static_cast<float>(i);
    light.diffuse *= 0.3F;
    light.specular *= 0.2F;
    settings.lights.push_back(light);
  }
  settings.ramp.enabled = false;  // eight lights leave few pixels that are near no step
  expect_shaded(settings);
}

TEST(Shade, too_many_lights_or_models_are_an_input_error) {
  Settings settings = small_scene();
  for (int i = 0; i < kMaxLights; ++i) settings.lights.push_back({.name = "light" + std::to_string(i)});
  Pipeline pipeline;
  EXPECT_NE(input_error_of([&] { pipeline.at(settings).raw(BufferName::shaded); }).find("65 lights"),
            std::string::npos);
  settings.lights.pop_back();
  EXPECT_NO_THROW(pipeline.at(settings).raw(BufferName::shaded));
}

TEST(Shade, last_of_the_lights_that_fit_and_of_more_materials_than_fit_at_once_is_used) {
  Settings settings = small_scene();
  settings.ramp.enabled = false;
  const Image expected = Pipeline().at(settings).raw(BufferName::shaded);
  LightParams dark{.name = "dark"};
  dark.diffuse = dark.specular = glm::vec3(0.0F);
  settings.lights.insert(settings.lights.begin(), kMaxLights - 1, dark);
  for (int i = 0; i + 1 < kMaxLights; ++i) settings.lights[i].name += std::to_string(i);
  ModelParams hidden{.visible = false, .shape = Shape::box};
  const size_t before =
      2 * kMaterialsAtOnce - 1;  // the first model that is seen is the last of the second go
  settings.models.insert(settings.models.begin(), before, hidden);
  for (size_t i = 0; i < before; ++i) settings.models[i].name = "hidden" + std::to_string(i);
  EXPECT_TRUE(is_near(Pipeline().at(settings).raw(BufferName::shaded), expected, 1e-6));
}

TEST(Shade, without_lights_shows_global_ambient_light) {
  Settings settings = analytic_scene();
  settings.lights.clear();
  expect_shaded(settings);
}

TEST(Shade, without_ramps_is_plain_blinn_phong) {
  Settings settings = analytic_scene();
  settings.ramp.enabled = false;
  Pipeline pipeline;
  EXPECT_EQ(largest_difference(pipeline.at(settings).raw(BufferName::shaded),
                               pipeline.at(settings).raw(BufferName::blinn_phong)),
            0.0);
}

TEST(Shade, blinn_phong_does_not_depend_on_ramps) {
  Settings settings = analytic_scene();
  Pipeline pipeline;
  const Image before = pipeline.at(settings).raw(BufferName::blinn_phong);
  settings.ramp.diffuse.stops[1].colour = {1.0F, 0.0F, 0.0F};
  settings.ramp.specular.stops[1].position = 0.2F;
  EXPECT_EQ(largest_difference(Pipeline().at(settings).raw(BufferName::blinn_phong), before), 0.0);
  settings.ramp.enabled = false;
  EXPECT_EQ(largest_difference(Pipeline().at(settings).raw(BufferName::blinn_phong), before), 0.0);
}

TEST(Shade, linear_ramp_is_plain_blinn_phong) {
  Settings settings = analytic_scene();
  settings.ramp.diffuse.stops = {{0.0F, glm::vec3(0.0F), false}, {1.0F, glm::vec3(1.0F), false}};
  settings.ramp.specular = settings.ramp.diffuse;
  Pipeline pipeline;
  // A table of 1024 colours is off by half of one in each of two lights' diffuse and specular terms.
  EXPECT_TRUE(is_near(pipeline.at(settings).raw(BufferName::shaded),
                      pipeline.at(settings).raw(BufferName::blinn_phong), 1.5e-3));
}

TEST(Shade, ramp_replaces_darkness_too) {
  // 3.2: the lookup stands in for NdotL also where it is 0, so the side away from the light has the ramp's
  // first colour.
  Settings settings = small_scene();
  settings.lights[0].direction = {0.0F, 0.0F, -1.0F};
  settings.lights[0].specular = glm::vec3(0.0F);
  settings.ramp.diffuse.stops = {{0.0F, {0.25F, 0.5F, 0.75F}, true}, {0.5F, glm::vec3(1.0F), true}};
  settings.models[0].material.colour = glm::vec3(1.0F);
  settings.scene.ambient = glm::vec3(0.0F);
  Pipeline pipeline;
  const Image shaded = pipeline.at(settings).raw(BufferName::shaded);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(shaded.at(24, 20, c), settings.ramp.diffuse.stops[0].colour[c], 1e-6);
}

TEST(Shade, ramp_image_is_read_at_its_nearest_pixel) {
  const TempFolder folder;
  constexpr std::array<std::array<uint8_t, 3>, 4> kColours{
      {{0, 51, 102}, {51, 102, 153}, {102, 153, 204}, {255, 204, 51}}};
  Picture picture(4, 2, 3, 255);  // the second row is not looked at
  Settings with_stops = analytic_scene();
  with_stops.ramp.diffuse.stops.clear();
  for (int x = 0; x < 4; ++x) {
    RampStop stop{static_cast<float>(x) / 4.0F, {}, true};
    for (int c = 0; c < 3; ++c) {
      picture.at(x, 0, c) = kColours[x][c];
      stop.colour[c] = static_cast<float>(kColours[x][c]) / 255.0F;
    }
    with_stops.ramp.diffuse.stops.push_back(stop);
  }
  Settings with_image = with_stops;
  with_image.ramp.diffuse.image = (folder.path() / "ramp.png").string();
  write_png(with_image.ramp.diffuse.image, picture, {});
  Pipeline pipeline;
  const Image expected = pipeline.at(with_stops).raw(BufferName::shaded);
  EXPECT_TRUE(is_near(pipeline.at(with_image).raw(BufferName::shaded), expected, 1e-6));
}

TEST(Shade, missing_ramp_image_is_an_input_error) {
  Settings settings = small_scene();
  settings.ramp.diffuse.image = "/nowhere/ramp.png";
  Pipeline pipeline;
  EXPECT_NE(input_error_of([&] { pipeline.at(settings).raw(BufferName::shaded); }).find("/nowhere/ramp.png"),
            std::string::npos);
}

}  // namespace
}  // namespace inkbench
