// SPDX-License-Identifier: MIT
// What the detectors other than the paper's and `dihedral` answer on real renders that have a closed form: a
// plane at any slant, a step, a right angle, a sphere, the same between other near and far planes.
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/explain.h"
#include "tests/gl/detector_support.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

/// A plane through the view's middle that covers the whole image, its normal turned by so much from the view.
Settings slanted_plane(float tilt_deg, float turn_deg = 0.0F) {
  Settings settings;
  settings.image = {64, 48, Precision::float32};
  settings.camera = {{0.0F, 0.0F, 5.0F}, {0.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, 20.0F, 0.1F, 60.0F};
  settings.models = {{.name = "plane",
                      .shape = Shape::plane,
                      .segments = 1,
                      .size = 50.0F,
                      .rotation = {90.0F - tilt_deg, 0.0F, turn_deg}}};
  return settings;
}

Image strength_of(Settings settings, EdgeMethod method) {
  settings.edges.method = method;
  Pipeline pipeline;
  return pipeline.at(settings).raw(BufferName::edge_strength);
}

double largest_of(const Image& image) {
  return *std::max_element(image.samples.begin(), image.samples.end());
}

TEST(DetectorFacts, laplacian_sees_no_plane_at_any_slant) {
  for (const float tilt : {0.0F, 30.0F, 60.0F, 70.0F}) {
    for (const float turn : {0.0F, 35.0F}) {
      Settings settings = slanted_plane(tilt, turn);
      settings.camera.view_height = 1.5F;
      if (turn > 0) settings.camera.projection = CameraProjection::orthographic;
      EXPECT_LT(largest_of(strength_of(settings, EdgeMethod::laplacian)), 0.02) << tilt;
      Pipeline pipeline;
      EXPECT_LT(largest_of(pipeline.at(settings).raw(BufferName::depth)), 1.0) << "it covers the image";
    }
  }
}

TEST(DetectorFacts, saito_takahashi_takes_a_slanted_plane_for_a_profile_by_its_slope_and_never_for_a_crease) {
  Settings settings = slanted_plane(70.0F, 20.0F);
  settings.saito_takahashi = {.profile = 10.0F, .crease = 0.001F};
  EXPECT_LT(largest_of(strength_of(settings, EdgeMethod::saito_takahashi)), 0.05) << "no second difference";
  settings.saito_takahashi = {.profile = 1.0F, .crease = 10.0F};
  const Image slope = strength_of(settings, EdgeMethod::saito_takahashi);
  // Affine depth: the same slope in the whole image, from 0 in one corner to 1 in the opposite one.
  const double steps = settings.image.width - 1, rows = settings.image.height - 1;
  EXPECT_GE(slope.at(30, 20), 1.0 / (steps + rows));
  EXPECT_LE(slope.at(30, 20), 1.0 / rows + 1.0 / steps);
  for (const float value : slope.samples) EXPECT_NEAR(value, slope.at(30, 20), 1e-4);
}

TEST(DetectorFacts, decaudin_and_mitchell_see_a_slanted_plane_by_its_depth_alone) {
  Settings settings = slanted_plane(70.0F);
  Pipeline pipeline;
  const Image depth = pipeline.at(settings).raw(BufferName::depth);
  settings.mitchell = {.angle = 0.1F, .depth = 1.0F};
  settings.decaudin = {.k_depth = 1.0F, .k_normal = 1.0F};
  const Image jumps = strength_of(settings, EdgeMethod::mitchell);
  EXPECT_NEAR(jumps.at(30, 10), depth.at(30, 9) - depth.at(30, 10), 1e-6) << "the largest of four neighbours";
  EXPECT_GT(jumps.at(30, 10), 0.001F);
  const double slope = depth.at(30, 9) - depth.at(30, 10);
  const double range = std::sqrt(strength_of(settings, EdgeMethod::decaudin).at(30, 10) / 2);
  EXPECT_GT(range, 0.02 * slope) << "depth is not affine on a plane: its slope changes";
  EXPECT_LT(range, 0.5 * slope) << "but from pixel to pixel by little";
}

/// Two planes that face the camera, the nearer one to the left of the image's middle.
Settings step_scene(float far = 20.0F, float near = 0.1F) {
  Settings settings = slanted_plane(0.0F);
  settings.image = {32, 24, Precision::float32};
  settings.camera.near = near;
  settings.camera.far = far;
  settings.models.push_back(settings.models.front());
  settings.models[1].name = "nearer";
  settings.models[1].size = 2.0F;
  settings.models[1].position = {-1.0F, 0.0F, 1.0F};  // its right border is in the middle
  return settings;
}

constexpr double kStepNear = 4, kStepFar = 5;  // distances of both planes

TEST(DetectorFacts, step_between_facing_planes_has_the_strength_of_the_equations) {
  Settings settings = step_scene();
  settings.mitchell.use_ids = false;
  const LensBlock lens = lens_of(settings.camera, settings.image.height);
  const double height = (kStepFar - kStepNear) / 20;
  const double ratio = height / 2 / settings.decaudin.k_depth;
  EXPECT_NEAR(strength_of(settings, EdgeMethod::decaudin).at(15, 12) / (2 * ratio * ratio), 1, 1e-4);
  EXPECT_NEAR(strength_of(settings, EdgeMethod::mitchell).at(15, 12), height / settings.mitchell.depth, 1e-3);
  EXPECT_NEAR(strength_of(settings, EdgeMethod::saito_takahashi).at(15, 12),
              0.5 / settings.saito_takahashi.profile, 1e-3)
      << "half of the way from the nearest to the farthest";
  const double w = 1 / kStepNear, other_w = 1 / kStepFar;
  EXPECT_NEAR(strength_of(settings, EdgeMethod::laplacian).at(15, 12) * settings.laplacian.bend,
              (w - other_w) / (w * lens.pixel_size), 1e-2);
  for (const EdgeMethod method : other_methods()) {
    const Image strength = strength_of(settings, method);
    for (int y = 0; y < 24; ++y) {
      for (const int x : {0, 5, 26, 31})
        EXPECT_LT(strength.at(x, y), 1)
            << name_of_method(method) << ": not beside it, nor at the image's border";
    }
  }
}

TEST(DetectorFacts, laplacian_and_saito_takahashi_do_not_know_the_cameras_planes_but_the_others_do) {
  for (const EdgeMethod method : {EdgeMethod::laplacian, EdgeMethod::saito_takahashi}) {
    const Image usual = strength_of(step_scene(), method),
                wide = strength_of(step_scene(1000.0F, 0.01F), method);
    for (size_t i = 0; i < usual.samples.size(); ++i)
      ASSERT_NEAR(wide.samples[i], usual.samples[i], 1e-3 * std::max(1.0F, usual.samples[i]))
          << name_of_method(method);
  }
  Settings usual = step_scene(), wide = step_scene(1000.0F, 0.01F);
  usual.mitchell.use_ids = wide.mitchell.use_ids = false;
  const auto at_step = [](const Settings& settings, EdgeMethod method) {
    return strength_of(settings, method).at(15, 12);
  };
  EXPECT_NEAR(at_step(usual, EdgeMethod::mitchell) / at_step(wide, EdgeMethod::mitchell), 50, 0.01);
  EXPECT_NEAR(at_step(usual, EdgeMethod::decaudin) / at_step(wide, EdgeMethod::decaudin), 2500, 2);
  EXPECT_LT(at_step(wide, EdgeMethod::mitchell), 1) << "no line any more";
}

TEST(DetectorFacts, explain_names_the_term_that_decides_and_what_it_lacks) {
  Settings settings = step_scene();
  settings.edges = {.method = EdgeMethod::mitchell, .weak = 0.5F};
  settings.mitchell.use_ids = false;
  Pipeline pipeline;
  const auto verdict = [&](float limit, int x) {
    settings.mitchell.depth = limit;
    return explain_pixel(pipeline.at(settings), x, 12).verdict;
  };
  EXPECT_EQ(verdict(0.04F, 15),
            "A line, because the step of the depth, 0.05 of far, reaches the limit 0.04 of far.");
  EXPECT_EQ(
      verdict(0.08F, 15),
      "A line only where one that reaches its limit goes on here: the step of the depth, 0.05 of far, is "
      "below the limit 0.08 of far.");
  EXPECT_EQ(
      verdict(0.2F, 15),
      "No line, because the step of the depth, 0.05 of far, is below the limit 0.2 of far, and all else is "
      "farther below its own.");
  EXPECT_EQ(verdict(0.04F, 5), "No line, because nothing differs here.");
  EXPECT_EQ(verdict(0.04F, 14),
            "No line, because nothing differs here. But a neighbour is a line, and lines are made 3 x 3 "
            "pixels wide.");
}

/// A box whose vertical edge is in the image's middle, seen from straight ahead.
Settings right_angle() {
  Settings settings;
  settings.image = {64, 64, Precision::float32};
  settings.camera.eye = {0.0F, 0.0F, 3.0F};
  settings.camera.target = glm::vec3(0.0F);
  settings.camera.fov = 10.0F;  // the outline is outside
  ModelParams box{.name = "box", .shape = Shape::box, .segments = 1};
  box.rotation.y = 45.0F;
  settings.models = {box};
  return settings;
}

double largest_in_the_middle(const Settings& settings, EdgeMethod method) {
  const Image strength = strength_of(settings, method);
  return std::max(strength.at(31, 32), strength.at(32, 32));
}

TEST(DetectorFacts, mitchells_limit_is_the_angle_of_a_crease) {
  Settings settings = right_angle();
  settings.mitchell.depth = 1.0F;
  for (const float angle : {89.9F, 90.1F}) {
    settings.mitchell.angle = angle;
    EXPECT_EQ(largest_in_the_middle(settings, EdgeMethod::mitchell) >= 1, angle < 90.0F) << angle;
  }
}

TEST(DetectorFacts, right_angle_answers_as_the_equations_say) {
  Settings settings = right_angle();
  const double bend = largest_in_the_middle(settings, EdgeMethod::laplacian) * settings.laplacian.bend;
  EXPECT_GE(bend, 0.97) << "half of 2, but for the perspective";
  EXPECT_LE(bend, 2.1);
  const double ratio = 0.5 * std::sqrt(2.0) / 2 / settings.decaudin.k_normal;  // N.x turns by sqrt(2)
  EXPECT_NEAR(largest_in_the_middle(settings, EdgeMethod::decaudin), 2 * ratio * ratio, 0.01);
  settings.saito_takahashi = {.profile = 10.0F, .crease = 1e-6F};
  EXPECT_EQ(largest_in_the_middle(settings, EdgeMethod::saito_takahashi), 2.0) << "the limiter";
}

TEST(DetectorFacts, smooth_sphere_has_its_outline_and_nothing_inside) {
  Settings settings = small_scene();
  settings.models[0].segments = 96;
  settings.image.width = 96;
  settings.image.height = 80;
  // The visible depth is the sphere's alone, which goes through all of it within few pixels.
  settings.saito_takahashi = {.profile = 0.1F, .crease = 0.01F};
  Pipeline pipeline;
  const Image ids = pipeline.at(settings).raw(BufferName::object_id);
  int left = 0, right = 95;
  while (ids.at(left, 40) == 0.0F) ++left;
  while (ids.at(right, 40) == 0.0F) --right;
  const double middle = (left + right) / 2.0, radius = (right - left) / 2.0;
  for (const EdgeMethod method : other_methods()) {
    const Image strength = strength_of(settings, method);
    EXPECT_GE(std::max(strength.at(left, 40), strength.at(left - 1, 40)), 1) << name_of_method(method);
    for (int x = 0; x < 96; ++x) {
      if (std::abs(x - middle) >= 0.7 * radius) continue;
      EXPECT_LT(strength.at(x, 40), 1) << name_of_method(method) << " " << x;
    }
  }
}

}  // namespace
}  // namespace inkbench
