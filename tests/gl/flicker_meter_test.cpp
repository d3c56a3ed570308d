// SPDX-License-Identifier: MIT
// Flicker of drawn scenes: none while the camera stands, little of true lines while it turns, and keys that
// follow the path.
#include <gtest/gtest.h>

#include "pipeline/settings/camera_path.h"
#include "studies/judging/drawing_meter.h"
#include "studies/sweep/run_study.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

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
