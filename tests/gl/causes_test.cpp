// SPDX-License-Identifier: MIT
// Causes of drawn scenes: one scene for each, at a pixel that is known; counts that add up; causes that a
// method has no term for.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "studies/judging/cause_finder.h"
#include "studies/judging/drawing_meter.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

constexpr int kMiddle = 60;

/// Two squares of side 1.6 that meet upright in the middle of the image, the right one bent back. Their
/// corners' normals, if any, lean away from each other by `split_degrees`.
std::string hinge_obj(double bend_degrees, double split_degrees) {
  const double bend = bend_degrees * M_PI / 180, split = split_degrees * M_PI / 360;
  const double x = 1.6 * std::cos(bend), z = -1.6 * std::sin(bend);
  std::string text = "v -1.6 -0.8 0\nv 0 -0.8 0\nv 0 0.8 0\nv -1.6 0.8 0\n";
  text += fmt::format("v {0} -0.8 {1}\nv {0} 0.8 {1}\n", x, z);
  if (split_degrees == 0) return text + "f 1 2 3 4\nf 2 5 6 3\n";
  text += fmt::format("vn {0} 0 {1}\nvn {2} 0 {1}\n", -std::sin(split), std::cos(split), std::sin(split));
  return text + "f 1//1 2//1 3//1 4//1\nf 2//2 5//2 6//2 3//2\n";
}

class CausesOfScenes : public testing::Test {
 protected:
  Settings hinge(double bend_degrees, ModelNormals normals, double split_degrees = 0) {
    Settings settings;
    settings.image = {2 * kMiddle, 2 * kMiddle, Precision::float32};
    settings.camera.eye = {0, 0, 4};
    settings.camera.fov = 35;
    const std::string mesh = folder_.write("hinge.obj", hinge_obj(bend_degrees, split_degrees)).string();
    settings.models = {{.name = "hinge", .mesh = mesh, .normals = normals}};
    settings.lights = {LightParams{.name = "sun"}};
    return settings;
  }
  /// A floor that ends far away.
  static Settings floor() {
    Settings settings = small_scene();
    settings.image = {2 * kMiddle, 2 * kMiddle, Precision::float32};
    settings.camera.eye = {0, 0.5F, 0};
    settings.camera.target = {0, 0.3F, -2};
    settings.models = {{.name = "floor", .shape = Shape::plane, .segments = 1, .size = 36}};
    return settings;
  }

  std::optional<PixelCause> at(const Settings& settings, int x, int y) {
    return find_cause(pipeline_, settings, x, y);
  }
  Cause cause_at(const Settings& settings, int x, int y) {
    const std::optional<PixelCause> found = at(settings, x, y);
    return found ? found->cause : Cause::none;
  }
  CauseCounts counts(const Settings& settings) { return count_causes(find_causes(pipeline_, settings)); }

  TempFolder folder_;
  Pipeline pipeline_;
};

TEST_F(CausesOfScenes, a_jump_of_split_normals_on_a_flat_surface_is_a_seam) {
  EXPECT_EQ(cause_at(hinge(0, ModelNormals::file, 20), kMiddle, kMiddle), Cause::seam);
  EXPECT_EQ(cause_at(hinge(0, ModelNormals::smooth, 20), kMiddle, kMiddle), Cause::none);
}

TEST_F(CausesOfScenes, flat_faces_that_bend_less_than_a_crease_have_a_facet_between_them) {
  EXPECT_EQ(cause_at(hinge(25, ModelNormals::flat), kMiddle, kMiddle), Cause::facet);
  EXPECT_EQ(cause_at(hinge(50, ModelNormals::flat), kMiddle, kMiddle), Cause::none) << "a crease is right";
}

TEST_F(CausesOfScenes, a_facet_of_the_surface_needs_no_normals) {
  Settings settings = hinge(25, ModelNormals::smooth);
  settings.edges.method = EdgeMethod::laplacian;
  settings.laplacian.bend = 0.1F;
  EXPECT_EQ(cause_at(settings, kMiddle, kMiddle), Cause::facet);
}

TEST_F(CausesOfScenes, a_floor_that_falls_away_to_the_horizon_is_grazing) {
  Settings settings = floor();
  settings.combine.k_depth = 2e-4F;
  const CauseCounts of = counts(settings);
  EXPECT_GT(of.of(Cause::grazing), 50);
  EXPECT_EQ(of.of(Cause::bend) + of.of(Cause::other_false), 0);
  settings.edges.method = EdgeMethod::laplacian;
  EXPECT_EQ(counts(settings).of(Cause::grazing), 0) << "it has no term that a slope alone fires";
}

TEST_F(CausesOfScenes, steps_between_eight_bit_levels_are_quantised) {
  Settings settings = floor();
  settings.camera.far = 3;
  settings.image.precision = Precision::unorm8;
  EXPECT_GT(counts(settings).of(Cause::quantised), 100);
  settings.image.precision = Precision::float32;
  EXPECT_EQ(counts(settings).of(Cause::quantised), 0);
}

TEST_F(CausesOfScenes, a_rounded_edge_that_a_larger_image_shows_round_is_a_bend) {
  Settings settings = hinge(0, ModelNormals::file);
  settings.camera.eye = {3, 0, 3};
  settings.models = {
      {.name = "box", .shape = Shape::rounded_box, .segments = 16, .fillet = 0.03F, .size = 1.6F}};
  settings.judge.ridge_curvature = 1000;  // the fillet is no ridge
  settings.combine.use_depth = false;
  settings.combine.k_normal = 0.06F;
  EXPECT_EQ(cause_at(settings, kMiddle, kMiddle), Cause::bend);
  settings.combine.k_normal = 0.03F;
  EXPECT_EQ(cause_at(settings, kMiddle, kMiddle), Cause::other_false) << "still a line at twice the size";
}

TEST_F(CausesOfScenes, what_a_tolerance_under_a_pixel_leaves_beside_each_other_is_doubled_and_displaced) {
  Settings settings = analytic_scene();
  settings.judge.tolerance = 0.5F;
  settings.image.width = settings.image.height = 100;
  CauseFinder finder(pipeline_, settings);
  while (finder.step()) {
  }
  const CauseMaps causes = finder.causes();
  EXPECT_GT(count_causes(causes).of(Cause::doubled), 20);
  EXPECT_GT(count_causes(causes).of(Cause::displaced), 20);
}

TEST_F(CausesOfScenes, models_that_touch_without_a_step_are_told_by_ids_alone) {
  Settings settings = hinge(0, ModelNormals::flat);
  ModelParams left{.name = "left", .shape = Shape::box, .segments = 1, .position = {-0.5F, 0, -0.5F}};
  ModelParams right = left;
  right.name = "right";
  right.position.x = 0.5F;
  settings.models = {left, right};
  EXPECT_EQ(cause_at(settings, kMiddle, kMiddle), Cause::same_id);
  settings.edges.method = EdgeMethod::mitchell;
  EXPECT_EQ(cause_at(settings, kMiddle, kMiddle), Cause::none);
}

TEST_F(CausesOfScenes, a_crease_under_smooth_normals_gives_normals_no_signal) {
  Settings settings = hinge(50, ModelNormals::smooth);
  settings.combine.use_depth = false;
  EXPECT_EQ(cause_at(settings, kMiddle, kMiddle), Cause::no_signal);
}

TEST_F(CausesOfScenes, a_crease_under_the_limit_is_drawn_by_the_factor_that_is_missing) {
  Settings settings = hinge(50, ModelNormals::flat);
  settings.combine.use_depth = false;
  settings.combine.k_normal = 0.5F;
  const std::optional<PixelCause> weak = at(settings, kMiddle, kMiddle);
  ASSERT_TRUE(weak);
  EXPECT_EQ(weak->cause, Cause::under_the_limit);
  const Image strength = pipeline_.at(settings).raw(BufferName::edge_strength);
  float most = 0;
  for (int x = weak->x - 2; x <= weak->x + 2; ++x) most = std::max(most, strength.at(x, weak->y));
  EXPECT_NEAR(weak->missing_factor, 1 / most, 1e-3);
  settings.combine.k_normal /= static_cast<float>(std::sqrt(1.01 * weak->missing_factor));  // it is squared
  EXPECT_NE(cause_at(settings, kMiddle, kMiddle), Cause::under_the_limit);
  EXPECT_GT(pipeline_.at(settings).raw(BufferName::combined_edges).at(weak->x, weak->y), 0);
}

TEST_F(CausesOfScenes, counts_add_up_to_what_precision_and_recall_count_with_every_method) {
  Settings settings = paper_scene(128, 128);
  MeasureNeeds needs;
  needs.add(*find_measure("precision"));
  needs.add(*find_measure("false_bend"));
  DrawingMeter meter(pipeline_, needs);
  for (const EdgeMethod method : {EdgeMethod::paper, EdgeMethod::decaudin, EdgeMethod::saito_takahashi,
                                  EdgeMethod::mitchell, EdgeMethod::laplacian, EdgeMethod::dihedral}) {
    settings.edges.method = method;
    const DrawingTally tally = meter.tally(pipeline_.at(settings));
    ASSERT_TRUE(tally.causes);
    int64_t wrong = 0, missed = 0;
    for (const CauseInfo& info : cause_table())
      (info.is_of_missed() ? missed : wrong) += tally.causes->of(info.cause);
    EXPECT_EQ(wrong, tally.lines.predicted - tally.lines.at_tolerance.allowed) << static_cast<int>(method);
    EXPECT_EQ(missed, tally.lines.referenced - tally.lines.at_tolerance.matched);
    EXPECT_GT(wrong + missed, 0);
  }
}

TEST_F(CausesOfScenes, a_slanted_plane_is_even_and_a_step_of_two_pixels_sizes_is_not) {
  for (const CameraProjection projection : {CameraProjection::perspective, CameraProjection::orthographic}) {
    CameraParams camera;
    camera.projection = projection;
    const bool is_ortho = projection == CameraProjection::orthographic;
    const double delta = pixel_size(camera, 1.0, 40);
    for (const double step : {0.0, 0.9, 1.1}) {  // sizes of a pixel, along the plane's normal
      Image depth(40, 40, 1);
      for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x) {
          // The plane z = 4 + X (X to the right), from x = 20 on moved back.
          const double across = (x + 0.5 - 20) * delta;
          const double plane = is_ortho ? 4 + across : 4 / (1 - across);
          const double here = is_ortho ? 1.0 : plane;  // what a pixel's size grows with
          const double back = x < 20 ? 0 : step * here * delta * std::sqrt(2.0);
          const double moved = is_ortho ? plane + back : (4 + back) / (1 - across);
          depth.at(x, y) = static_cast<float>(moved / camera.far);
        }
      }
      const LineMap even = even_pixels(depth, camera, 1);
      EXPECT_TRUE(even.at(5, 20));
      EXPECT_EQ(even.at(19, 20), step < 1) << step << is_ortho;
    }
  }
}

}  // namespace
}  // namespace inkbench
