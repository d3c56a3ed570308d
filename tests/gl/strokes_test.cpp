// SPDX-License-Identifier: MIT
// Strokes as OpenGL draws them, against the union of discs that they are.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/image/png_file.h"
#include "pipeline/passes/strokes/stroke_draw.h"
#include "pipeline/passes/strokes/stroke_tiles.h"
#include "pipeline/passes/strokes/strokes.h"
#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"
#include "tests/unit/strokes_support.h"

namespace inkbench {
namespace {

ImageWindow window_of(int width, int height) {
  return {0, 0, width, height, width, height, std::nullopt};
}

/// The classes' channels one above the other, H x W x 12.
Image drawn_channels(const Strokes& strokes, const BrushParams& brush = {},
                     const std::optional<ImageWindow>& window = std::nullopt) {
  const StrokeDrawPass pass(generated_sources());
  const StrokeChannels channels =
      pass.run(brush, window.value_or(window_of(strokes.width_px, strokes.height_px)), strokes);
  Image result(channels.classes[0].width_px(), channels.classes[0].height_px(), 12);
  for (int i = 0; i < 3; ++i) {
    const Image part = channels.classes[i].read(0, 4);
    for (int y = 0; y < result.height_px; ++y)
      for (int x = 0; x < result.width_px; ++x)
        for (int c = 0; c < 4; ++c) result.at(x, y, 4 * i + c) = part.at(x, y, c);
  }
  return result;
}

Image channel_of(const Image& channels, CurveClass curve_class) {
  return make_image(channels.width_px, channels.height_px,
                    [&](int x, int y) { return channels.at(x, y, static_cast<int>(curve_class)); });
}

/// Of one pixel by all discs, so many that it makes no difference.
double share_of(const Stroke& stroke, const glm::dvec2& here) {
  double inside = -1e9, radius = 0.0;
  for (size_t i = 1; i < stroke.points.size(); ++i) {
    const StrokePoint &a = stroke.points[i - 1], &b = stroke.points[i];
    constexpr int kDiscs = 1000;
    for (int k = 0; k <= kDiscs; ++k) {
      const double t = k / double{kDiscs}, r = a.radius_px + t * (b.radius_px - a.radius_px);
      const glm::dvec2 at = glm::dvec2(a.at) + t * (glm::dvec2(b.at) - glm::dvec2(a.at));
      if (r - glm::distance(at, here) <= inside) continue;
      inside = r - glm::distance(at, here);
      radius = r;
    }
  }
  return std::clamp(inside + 0.5, 0.0, std::min(1.0, 2.0 * radius));
}

Image reference_of(const Strokes& strokes) {
  return make_image(strokes.width_px, strokes.height_px, [&](int x, int y) {
    double share = 0.0;
    for (const Stroke& stroke : strokes.strokes)
      share = std::max(share, share_of(stroke, {x + 0.5, y + 0.5}));
    return share;
  });
}

Stroke stroke_of(std::vector<StrokePoint> points) {
  float along = 0.0F;
  for (size_t i = 0; i < points.size(); ++i) {
    if (i > 0) along += glm::distance(points[i - 1].at, points[i].at);
    points[i].along_px = along;
  }
  return {.start_px = 0.0F, .end_px = along, .points = std::move(points)};
}

/// Eight bits, and discs that are left out.
constexpr double kStep = 0.5 / 255.0 + 2e-3;

TEST(StrokesDrawn, a_segment_is_the_union_of_its_discs) {
  for (const auto& [from, to] :
       {std::pair{4.0F, 4.0F}, {6.0F, 1.0F}, {0.3F, 0.3F}, {0.0F, 3.0F}, {14.0F, 1.0F}}) {
    const Strokes strokes{64, 48, {stroke_of({{{20.3F, 17.1F}, from}, {{44.2F, 29.7F}, to}})}, {}};
    EXPECT_TRUE(
        is_near(channel_of(drawn_channels(strokes), CurveClass::silhouette), reference_of(strokes), kStep))
        << from << " to " << to;
  }
}

TEST(StrokesDrawn, bends_narrower_than_the_stroke_have_no_holes) {
  std::vector<StrokePoint> points;
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.15 * i, radius = 3.0 + 0.25 * i;
    points.push_back({{40.0 + radius * std::cos(angle), 40.0 + radius * std::sin(angle)}, 6.0F});
  }
  const Strokes strokes{80, 80, {stroke_of(std::move(points))}, {}};
  EXPECT_TRUE(
      is_near(channel_of(drawn_channels(strokes), CurveClass::silhouette), reference_of(strokes), kStep));
}

TEST(StrokesDrawn, joins_and_crossings_are_not_doubled) {
  const Strokes strokes{64,
                        64,
                        {stroke_of({{{10, 10}, 1.2F}, {{30, 12}, 1.2F}, {{31, 40}, 1.2F}, {{12, 52}, 1.2F}}),
                         stroke_of({{{5, 40}, 1.5F}, {{60, 20}, 0.7F}})},
                        {}};
  EXPECT_TRUE(
      is_near(channel_of(drawn_channels(strokes), CurveClass::silhouette), reference_of(strokes), kStep));
}

TEST(StrokesDrawn, each_class_has_a_channel_of_its_own) {
  Strokes strokes{40, 40, {}, {}};
  for (size_t i = 0; i < kCurveClasses; ++i) {
    const float y = 1.5F + 3.0F * static_cast<float>(i);
    strokes.strokes.push_back(stroke_of({{{5, y}, 1.0F}, {{35, y}, 1.0F}}));
    for (StrokePoint& point : strokes.strokes.back().points) point.curve_class = static_cast<CurveClass>(i);
  }
  const Image channels = drawn_channels(strokes);
  for (int i = 0; i < static_cast<int>(kCurveClasses); ++i) {
    for (int c = 0; c < static_cast<int>(kCurveClasses); ++c)
      EXPECT_EQ(channels.at(20, 1 + 3 * i, c), c == i ? 1.0F : 0.0F) << i << ", " << c;
  }
}

TEST(StrokesDrawn, covered_strokes_are_as_opaque_as_asked_for) {
  Strokes strokes{40, 40, {stroke_of({{{5, 20}, 3.0F}, {{35, 20}, 3.0F}})}, {}};
  strokes.strokes[0].covered = 1;
  EXPECT_NEAR(drawn_channels(strokes, {.hidden_opacity = 0.4F}).at(20, 20, 0), 0.4F, 0.002F);
}

TEST(StrokesDrawn, a_part_of_the_image_is_what_the_whole_shows_there) {
  const Strokes strokes{64, 48, {stroke_of({{{4, 40}, 2.0F}, {{30, 8}, 5.0F}, {{60, 30}, 1.0F}})}, {}};
  const Image whole = drawn_channels(strokes);
  const Image part = drawn_channels(strokes, {}, ImageWindow{13, 5, 31, 22, 64, 48, std::nullopt});
  for (int y = 0; y < 22; ++y)
    for (int x = 0; x < 31; ++x)
      ASSERT_NEAR(part.at(x, y, 0), whole.at(x + 13, y + 48 - 5 - 22, 0), 1.01F / 255.0F) << x << ", " << y;
}

TEST(StrokesDrawn, brushes_leave_paint_out_but_never_add_any) {
  const Strokes strokes{64, 48, {stroke_of({{{8, 30}, 5.0F}, {{30, 10}, 6.0F}, {{56, 36}, 3.0F}})}, {}};
  const Image solid = drawn_channels(strokes);
  for (const Brush brush : {Brush::pencil, Brush::charcoal, Brush::marker, Brush::image}) {
    const Image painted = drawn_channels(strokes, {.brush = brush, .grain = 0.7F});
    double left_out = 0.0;
    for (size_t i = 0; i < solid.samples.size(); ++i) {
      ASSERT_LE(painted.samples[i], solid.samples[i] + 1.01F / 255.0F);
      left_out += solid.samples[i] - painted.samples[i];
    }
    EXPECT_TRUE(brush == Brush::image || left_out > 20.0) << static_cast<int>(brush);
  }
}

TEST(StrokesDrawn, paint_stays_on_the_stroke_when_the_stroke_moves) {
  for (const Brush brush : {Brush::ink, Brush::pencil, Brush::charcoal, Brush::marker}) {
    Stroke stroke = stroke_of({{{8, 20}, 5.0F}, {{50, 20}, 5.0F}});
    const Image here = drawn_channels({64, 64, {stroke}, {}}, {.brush = brush});
    for (StrokePoint& point : stroke.points) point.at += glm::vec2(6.0F, 9.0F);
    const Image there = drawn_channels({64, 64, {stroke}, {}}, {.brush = brush});
    for (int y = 10; y < 32; ++y)
      for (int x = 0; x < 58; ++x)
        ASSERT_NEAR(there.at(x + 6, y + 9, 0), here.at(x, y, 0), 0.03F) << x << ", " << y;
  }
}

TEST(StrokesDrawn, paint_is_picked_by_where_the_nearest_part_of_the_stroke_is) {
  // Of a picture that is dark on its left half, each repetition of 16 px is painted on its first 8.
  TempFolder folder;
  const Picture half = [] {
    Picture picture(16, 1, 1, 255);
    for (int x = 0; x < 8; ++x) picture.at(x, 0) = 0;
    return picture;
  }();
  write_png(folder.path() / "half.png", half, {});
  const std::string image = (folder.path() / "half.png").string();
  const Strokes strokes{80, 40, {stroke_of({{{8, 20}, 6.0F}, {{72, 20}, 6.0F}})}, {}};
  const Image drawn = drawn_channels(strokes, {Brush::image, image, 16.0F, BrushFit::tile, 1.0F, 1.0F});
  for (const int start : {8, 24, 40, 56}) {
    EXPECT_GT(drawn.at(start + 3, 20, 0), 0.99F) << start;
    EXPECT_LT(drawn.at(start + 11, 20, 0), 0.01F) << start;
  }
  const Image once = drawn_channels(strokes, {Brush::image, image, 16.0F, BrushFit::stretch, 1.0F, 1.0F});
  EXPECT_GT(once.at(30, 20, 0), 0.99F);
  EXPECT_LT(once.at(50, 20, 0), 0.01F);
}

Settings strokes_of_a_scene() {
  Settings settings = analytic_scene();
  settings.ink.from = InkFrom::strokes;
  settings.stroke.width = 3.0F;
  return settings;
}

TEST(StrokeTiles, have_every_painted_pixel_of_any_part_of_the_image_and_not_the_whole_of_it) {
  const Strokes strokes = *Pipeline().at(strokes_of_a_scene()).value<StrokesPass>();
  const int whole_width = strokes.width_px, whole_height = strokes.height_px;
  for (const ImageWindow& window :
       {window_of(whole_width, whole_height),
        ImageWindow{13, 9, whole_width - 30, whole_height - 21, whole_width, whole_height, std::nullopt}}) {
    const Image tiles = stroke_tiles(strokes, window);
    const Image drawn = drawn_channels(strokes, {}, window);
    double empty = 0;
    for (const float tile : tiles.samples) empty += 1.0 - tile;
    EXPECT_GT(empty, 0.2 * static_cast<double>(tiles.samples.size()));
    for (int y = 0; y < drawn.height_px; ++y) {
      const int row = tiles.height_px - 1 - (drawn.height_px - 1 - y) / 8;
      for (int x = 0; x < drawn.width_px; ++x)
        for (int c = 0; c < 12; ++c)
          ASSERT_TRUE(drawn.at(x, y, c) == 0.0F || tiles.at(x / 8, row) == 1.0F) << x << ", " << y;
    }
  }
}

TEST(StrokesDrawn, without_strokes_nothing_is_drawn) {
  for (const float sample : drawn_channels({16, 16, {}, {}}).samples) ASSERT_EQ(sample, 0.0F);
}

}  // namespace
}  // namespace inkbench
