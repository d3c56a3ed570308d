// SPDX-License-Identifier: MIT
// The detectors' lines as curves, from pictures of known forms.
#include "pipeline/passes/curves/traced_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "pipeline/passes/placing/connect.h"
#include "pipeline/passes/placing/placed_lines.h"
#include "pipeline/pipeline.h"
#include "tests/gl/scenes.h"
#include "tests/traced_support.h"

namespace inkbench {
namespace {

constexpr EdgeMethod kMethods[] = {EdgeMethod::paper,    EdgeMethod::decaudin,  EdgeMethod::saito_takahashi,
                                   EdgeMethod::mitchell, EdgeMethod::laplacian, EdgeMethod::dihedral};

/// Seen straight from the front, 100 px to the world's unit at z = 0.
Settings front_view(std::vector<ModelParams> models) {
  Settings settings;
  settings.image.width = 200;
  settings.image.height = 160;
  settings.camera = {.eye = {0.0F, 0.0F, 5.0F}, .target = {0.0F, 0.0F, 0.0F}, .near = 1.0F, .far = 20.0F};
  settings.camera.projection = CameraProjection::orthographic;
  settings.camera.view_height = 1.6F;
  settings.models = std::move(models);
  settings.edges.method = EdgeMethod::dihedral;
  return settings;
}

ModelParams block(const std::string& name, glm::vec3 middle, glm::vec3 size) {
  return {.name = name, .shape = Shape::box, .segments = 1, .position = middle, .scale = size};
}

LinePixels traced_pixels(const Frame& frame) {
  const std::shared_ptr<const GBuffer> gbuffer = frame.value<GBufferPass>();
  return line_pixels_of(frame.value<ConnectPass>()->read_picture(),
                        {gbuffer->normal_and_depth.read(3, 1), gbuffer->object_id.read(0, 1)},
                        frame.settings().camera.far);
}

TEST(TracedCurves, follow_every_methods_lines_and_these_them) {
  Pipeline pipeline;
  for (const EdgeMethod method : kMethods) {
    for (const float reach_px : {0.75F, 0.3F}) {
      Settings settings = analytic_scene();
      settings.edges.method = method;
      settings.curves.image_smoothing = reach_px;
      const Frame frame = pipeline.at(settings);
      const Segments pixels = segments_of(traced_pixels(frame));
      const Segments curves = segments_of(*frame.value<TracedCurvesPass>());
      ASSERT_GT(pixels.size(), 300U) << static_cast<int>(method);
      EXPECT_LE(farthest(curves, pixels), reach_px + 1e-4F) << static_cast<int>(method);
      EXPECT_LE(farthest(pixels, curves), reach_px + 1e-4F) << static_cast<int>(method);
    }
  }
}

TEST(TracedCurves, placed_lines_read_as_bytes_are_those_read_as_floats) {
  Pipeline pipeline;
  const std::shared_ptr<const Texture> placed = pipeline.at(analytic_scene()).value<ConnectPass>();
  const Picture bytes = placed->read_picture();
  const Image floats = placed->read(0, 4);
  int lines = 0;
  for (int y = 0; y < bytes.height_px; ++y) {
    for (int x = 0; x < bytes.width_px; ++x) {
      const PlacedLine a = placed_at(bytes, x, y), b = placed_at(floats, x, y);
      ASSERT_EQ(a.line_class, b.line_class);
      ASSERT_NEAR(a.offset_x, b.offset_x, 1e-4F);
      ASSERT_NEAR(a.offset_y, b.offset_y, 1e-4F);
      lines += a.line_class != EdgeClass::none ? 1 : 0;
    }
  }
  EXPECT_GT(lines, 300);
}

TEST(TracedCurves, a_ball_is_one_ring_with_nothing_behind) {
  Pipeline pipeline;
  ModelParams ball{.name = "ball", .shape = Shape::sphere, .segments = 96, .size = 1.0F};
  const Settings settings = front_view({ball});
  // The others' outlines run beside further lines, or their pixels are of several classes.
  for (const EdgeMethod method :
       {EdgeMethod::paper, EdgeMethod::decaudin, EdgeMethod::mitchell, EdgeMethod::dihedral}) {
    Settings other = settings;
    other.edges.method = method;
    const Frame frame = pipeline.at(other);
    const std::shared_ptr<const Curves> curves = frame.value<TracedCurvesPass>();
    const auto outline =
        std::ranges::max_element(curves->curves, {}, [](const Curve& curve) { return length_px(curve); });
    ASSERT_NE(outline, curves->curves.end());
    EXPECT_TRUE(outline->is_closed()) << static_cast<int>(method);
    EXPECT_EQ(outline->curve_class, CurveClass::object) << static_cast<int>(method);
    EXPECT_EQ(outline->behind, Behind::nothing) << static_cast<int>(method);
    EXPECT_EQ(outline->object_id, 1) << static_cast<int>(method);
    float farthest_away = 0.0F, farthest_depth = 0.0F;
    for (const glm::vec2& point : outline->points)
      farthest_away = std::max(farthest_away, std::abs(glm::distance(point, {100.0F, 80.0F}) - 49.5F));
    for (const float depth : outline->depths)
      farthest_depth = std::max(farthest_depth, std::abs(depth - 5.0F));
    EXPECT_LT(farthest_away, 1.5F) << static_cast<int>(method);
    EXPECT_LT(farthest_depth, 0.2F) << static_cast<int>(method);
  }
}

TEST(TracedCurves, a_square_is_one_ring_with_its_corners) {
  Pipeline pipeline;
  const Curves curves =
      *pipeline.at(front_view({block("box", {}, glm::vec3(0.8F))})).value<TracedCurvesPass>();
  ASSERT_EQ(curves.curves.size(), 1U);
  EXPECT_TRUE(curves.curves[0].is_closed());
  for (const glm::vec2 corner : {glm::vec2(60, 40), {140, 40}, {60, 120}, {140, 120}}) {
    float least = 1e9F;
    for (const auto& segment : segments_of(curves)) least = std::min(least, distance_to(segment, corner));
    EXPECT_LT(least, 1.5F);
  }
}

TEST(TracedCurves, where_one_block_covers_anothers_outline_that_ends_on_its_own) {
  Pipeline pipeline;
  const Settings settings = front_view({block("front", {0.0F, 0.2F, 1.0F}, {1.2F, 0.4F, 0.2F}),
                                        block("back", {0.0F, -0.2F, 0.0F}, {0.3F, 0.8F, 0.2F})});
  const Curves curves = *pipeline.at(settings).value<TracedCurvesPass>();
  const auto is_of = [](int id) { return [=](const Curve& curve) { return curve.object_id == id; }; };
  ASSERT_EQ(std::ranges::count_if(curves.curves, is_of(2)), 1);
  const Curve& stem = *std::ranges::find_if(curves.curves, is_of(2));
  EXPECT_EQ(stem.start, CurveEnd::junction);
  EXPECT_EQ(stem.end, CurveEnd::junction);
  Segments front;
  for (const Curve& curve : curves.curves) {
    if (curve.object_id != 1) continue;
    for (size_t i = 1; i < curve.points.size(); ++i) front.emplace_back(curve.points[i - 1], curve.points[i]);
  }
  for (const glm::vec2& end : {stem.points.front(), stem.points.back()}) {
    float least = 1e9F;
    for (const auto& segment : front) least = std::min(least, distance_to(segment, end));
    EXPECT_LT(least, 1e-3F);
  }
}

TEST(TracedCurves, between_two_blocks_another_object_is_behind) {
  Pipeline pipeline;
  const Settings settings = front_view({block("front", {0.0F, 0.0F, 1.0F}, glm::vec3(0.4F)),
                                        block("back", {0.0F, 0.0F, -1.0F}, {1.2F, 1.2F, 0.2F})});
  const Curves curves = *pipeline.at(settings).value<TracedCurvesPass>();
  ASSERT_EQ(curves.curves.size(), 2U);
  for (const Curve& curve : curves.curves)
    EXPECT_EQ(curve.behind, curve.object_id == 1 ? Behind::other_object : Behind::nothing);
}

TEST(TracedCurves, of_a_part_lie_where_those_of_the_whole_image_do) {
  Pipeline pipeline;
  const Settings settings = front_view({block("box", {}, glm::vec3(0.8F))});
  const Segments whole = segments_of(*pipeline.at(settings).value<TracedCurvesPass>());
  ImageWindow part = whole_image(settings.image);
  part.left = 40;
  part.bottom = 70;
  part.width = 60;
  part.height = 70;
  const Curves curves = *pipeline.at(settings, part).value<TracedCurvesPass>();
  EXPECT_EQ(curves.width_px, 200);
  const Segments cut = segments_of(curves);
  ASSERT_GT(cut.size(), 60U);
  EXPECT_LT(farthest(cut, whole), 0.8F);
}

}  // namespace
}  // namespace inkbench
