// SPDX-License-Identifier: MIT
// Flicker of drawn scenes: none while the camera stands, little of true lines while it turns, and keys that
// follow the path.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

#include "pipeline/settings/camera_path.h"
#include "studies/judging/drawing_meter.h"
#include "studies/sweep/run_study.h"
#include "tests/gl/checks.h"
#include "tests/gl/cpu_rays.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

/// One way of a pair of frames, pixel by pixel out of the definition: the models stand, the camera moves.
struct ByHand {
  const Settings& from;
  const Settings& to;
  const Image& depth;
  const Image& other_depth;
  int carried = 0, alone = 0;

  void count(const LineMap& lines, const LineMap& others) {
    for (const Pixel& pixel : pixels_of(lines)) {
      const std::optional<glm::dvec2> place = landing(pixel);
      if (!place) continue;
      ++carried;
      double nearest = 1e9;
      for (const Pixel& other : pixels_of(others))
        nearest = std::min(nearest, std::hypot(other.x + 0.5 - place->x, other.y + 0.5 - place->y));
      alone += nearest > 2 ? 1 : 0;
    }
  }
  std::optional<glm::dvec2> landing(const Pixel& pixel) const {
    Pixel surface = pixel;  // within 2 px, the nearest to the eye
    for (int y = pixel.y - 2; y <= pixel.y + 2; ++y) {
      for (int x = pixel.x - 2; x <= pixel.x + 2; ++x) {
        const bool is_near = std::hypot(x - pixel.x, y - pixel.y) <= 2;
        if (is_near && depth.at(x, y) < depth.at(surface.x, surface.y)) surface = {x, y};
      }
    }
    const double distance = double{depth.at(surface.x, surface.y)} * from.camera.far;
    if (distance >= from.camera.far) return std::nullopt;
    const glm::dvec3 ray =
        reference::pixel_ray(from.camera, surface.x, surface.y, depth.width_px, depth.height_px);
    const glm::dvec3 there = reference::seen_at(to, glm::dvec3(from.camera.eye) + distance * ray);
    const glm::dvec2 place(pixel.x + there.x - surface.x, pixel.y + there.y - surface.y);
    const bool is_inside =
        place.x >= 4 && place.y >= 4 && place.x <= depth.width_px - 4 && place.y <= depth.height_px - 4;
    if (!is_inside) return std::nullopt;
    double farthest = 0;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx)
        farthest = std::max<double>(
            farthest, other_depth.at(static_cast<int>(there.x) + dx, static_cast<int>(there.y) + dy));
    }
    if (1 / there.z < (1 - 0.001) / (farthest * to.camera.far)) return std::nullopt;
    return place;
  }
};

MeasureNeeds flicker_needs() {
  MeasureNeeds needs;
  for (const char* key : {"flicker", "flicker_reference"}) needs.add(*find_measure(key));
  return needs;
}

/// Over the frames of the path.
DrawingTally flicker_along(Pipeline& pipeline, const CameraPath& path, const Settings& settings) {
  DrawingMeter meter(pipeline, flicker_needs());
  DrawingTally sum;
  std::optional<Frame> before;
  for (int i = 0; i < path.frames; ++i) {
    const Frame frame = pipeline.at(settings_at(path, settings, i));
    sum.add(meter.tally(frame, before ? &*before : nullptr));
    before = frame;
  }
  return sum;
}

Settings shapes() {
  Settings settings = analytic_scene();
  settings.image.width = 240;
  settings.image.height = 180;
  return settings;
}

TEST(FlickerMeter, a_camera_that_stands_still_shows_none) {
  Pipeline pipeline;
  const DrawingTally tally = flicker_along(pipeline, {.frames = 3, .degrees = 0}, shapes());
  ASSERT_TRUE(tally.flicker);
  EXPECT_EQ(tally.flicker->drawn.share(), 0.0);
  EXPECT_EQ(tally.flicker->wanted.share(), 0.0);
  EXPECT_GT(tally.flicker->drawn.carried, 2000);
  EXPECT_GT(tally.flicker->wanted.carried, 2000);
}

TEST(FlickerMeter, true_lines_of_shapes_hardly_flicker_while_the_camera_turns) {
  Pipeline pipeline;
  const DrawingTally tally = flicker_along(pipeline, {.frames = 5, .degrees = 10}, shapes());
  EXPECT_GT(tally.flicker->wanted.carried, 2000);
  EXPECT_LT(*tally.flicker->wanted.share(), 0.02) << "lines that were carried wrongly would all die";
}

TEST(FlickerMeter, counts_what_the_definition_says_pixel_by_pixel) {
  Pipeline pipeline;
  Settings before = shapes();
  before.combine.k_normal = 0.003F;  // many lines that do not last
  const Settings now = settings_at({.frames = 30, .degrees = 180}, before, 1);
  const auto lines = [&](const Settings& settings) {
    return counted_lines(line_map_from(pipeline.at(settings).raw(BufferName::lines)));
  };
  const auto depth = [&](const Settings& settings) { return pipeline.at(settings).raw(BufferName::depth); };
  const Image depth_before = depth(before), depth_now = depth(now);
  const LineMap lines_before = lines(before), lines_now = lines(now);
  ByHand ahead{before, now, depth_before, depth_now}, back{now, before, depth_now, depth_before};
  ahead.count(lines_before, lines_now);
  back.count(lines_now, lines_before);
  DrawingMeter meter(pipeline, flicker_needs());
  const Frame past = pipeline.at(before);
  const FlickerCounts counts = meter.tally(pipeline.at(now), &past).flicker->drawn;
  EXPECT_GT(ahead.alone + back.alone, 20) << "something comes and goes";
  // A point within 1/256 px of a limit may fall on its other side.
  EXPECT_NEAR(static_cast<double>(counts.died), ahead.alone, 1);
  EXPECT_NEAR(static_cast<double>(counts.born), back.alone, 1);
  EXPECT_NEAR(static_cast<double>(counts.carried), ahead.carried + back.carried, 2);
}

TEST(FlickerMeter, an_empty_drawing_has_no_value) {
  Pipeline pipeline;
  Settings settings = shapes();
  settings.combine.use_depth = settings.combine.use_normal = false;
  const DrawingTally tally = flicker_along(pipeline, {.frames = 2, .degrees = 4}, settings);
  EXPECT_EQ(find_measure("flicker")->value(tally), std::nullopt);
  EXPECT_TRUE(find_measure("flicker_reference")->value(tally).has_value());
}

TEST(FlickerMeter, a_first_frame_has_no_flicker) {
  Pipeline pipeline;
  EXPECT_FALSE(DrawingMeter(pipeline, flicker_needs()).tally(pipeline.at(small_scene())).flicker);
}

TEST(FlickerMeter, finds_the_lines_of_each_frame_once) {
  Pipeline pipeline;
  flicker_along(pipeline, {.frames = 4, .degrees = 8}, small_scene());
  const std::map<std::string, StageCount> counts = pipeline.counts();
  EXPECT_EQ(counts.at("gbuffer").runs, 5) << "the first once more: only then it is known that two are needed";
  EXPECT_EQ(counts.at("reference").runs, 4);
  EXPECT_EQ(counts.at("motion").runs, 6) << "there and back between neighbours";
}

TEST(FlickerMeter, the_key_follows_both_frames) {
  Pipeline pipeline;
  DrawingMeter meter(pipeline, flicker_needs());
  const Settings settings = small_scene();
  const auto key_after = [&](double degrees) {
    const CameraPath path{.frames = 2, .degrees = static_cast<float>(degrees)};
    const Frame before = pipeline.at(settings), now = pipeline.at(settings_at(path, settings, 1));
    return meter.key(now, &before);
  };
  EXPECT_EQ(key_after(4), key_after(4));
  EXPECT_NE(key_after(4), key_after(6));
  const Frame same = pipeline.at(settings);
  Settings other = settings;
  other.combine.k_normal *= 2;
  const Frame drawn_otherwise = pipeline.at(other);
  EXPECT_NE(meter.key(same, &same), meter.key(same, &drawn_otherwise));
  EXPECT_NE(meter.key(same, &same), meter.key(same));
}

}  // namespace
}  // namespace inkbench
