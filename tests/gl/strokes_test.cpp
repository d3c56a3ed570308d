// SPDX-License-Identifier: MIT
// Strokes as OpenGL draws them, against the union of discs that they are.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/image/png_file.h"
#include "pipeline/passes/strokes/stroke_colours.h"
#include "pipeline/passes/strokes/stroke_draw.h"
#include "pipeline/passes/strokes/stroke_ink.h"
#include "pipeline/passes/strokes/strokes.h"
#include "pipeline/pipeline.h"
#include "pipeline/strokes/carry_along.h"
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

/// Colours of channels that one pixel has, by class.
glm::vec4 colour_of(const StrokeLook& look, const std::vector<std::pair<CurveClass, float>>& shares) {
  StrokeChannels channels;
  for (int i = 0; i < 3; ++i) {
    Image image(1, 1, 4);
    for (const auto& [curve_class, share] : shares) {
      if (static_cast<int>(curve_class) / 4 == i) image.at(0, 0, static_cast<int>(curve_class) % 4) = share;
    }
    channels.classes[i] = to_texture(image);
  }
  const Image colours = StrokeColoursPass(generated_sources()).run(look, channels).read(0, 4);
  return {colours.at(0, 0, 0), colours.at(0, 0, 1), colours.at(0, 0, 2), colours.at(0, 0, 3)};
}

bool is_close(const glm::vec4& a, const glm::vec4& b) {
  return glm::distance(a, b) < 1e-5F;
}

StrokeLook plain_look(const glm::vec3& ink, float opacity) {
  StrokeLook look{.ink = ink};
  for (glm::vec4& of_class : look.of_class) of_class.w = opacity;
  return look;
}

TEST(StrokeColours, hide_as_much_as_covers_times_the_opacity) {
  const glm::vec4 colour = colour_of(plain_look({0.2F, 0.0F, 0.4F}, 0.5F), {{CurveClass::crease, 0.6F}});
  EXPECT_TRUE(is_close(colour, {0.3F * 0.2F + 0.7F, 0.7F, 0.3F * 0.4F + 0.7F, 0.3F}));
}

TEST(StrokeColours, where_a_stroke_goes_over_from_class_to_class_nothing_is_doubled) {
  const glm::vec4 colour =
      colour_of(plain_look({}, 1.0F), {{CurveClass::silhouette, 0.5F}, {CurveClass::crease, 0.5F}});
  EXPECT_TRUE(is_close(colour, {0.5F, 0.5F, 0.5F, 0.5F}));
}

TEST(StrokeColours, by_class_the_earlier_one_is_on_top) {
  StrokeLook look = plain_look({}, 1.0F);
  look.colour = StrokeColour::by_class;
  look.of_class[0] = {1.0F, 0.0F, 0.0F, 1.0F};
  look.of_class[3] = {0.0F, 0.0F, 1.0F, 1.0F};
  const glm::vec4 colour = colour_of(look, {{CurveClass::silhouette, 0.25F}, {CurveClass::crease, 1.0F}});
  EXPECT_TRUE(is_close(colour, {0.25F, 0.0F, 0.75F, 1.0F}));
}

TEST(StrokeInk, is_the_largest_coverage_and_its_class) {
  StrokeChannels channels;
  for (Texture& texture : channels.classes) texture = to_texture(Image(1, 1, 4));
  Image first(1, 1, 4);
  first.at(0, 0, 0) = 0.3F;
  first.at(0, 0, 3) = 0.8F;
  channels.classes[0] = to_texture(first);
  const Image ink = StrokeInkPass(generated_sources()).run(channels).read(0, 2);
  EXPECT_NEAR(ink.at(0, 0, 0), 0.8F, 0.003F);
  EXPECT_EQ(std::lround(ink.at(0, 0, 1) * 255.0F), static_cast<int>(EdgeClass::crease));
}

Settings stroked_scene(InkFrom from) {
  Settings settings = analytic_scene();
  settings.ink.from = from;
  settings.stroke.width = 3.0F;
  return settings;
}

TEST(InkFrom, strokes_are_what_lines_and_coverage_show) {
  Pipeline pipeline;
  const Frame frame = pipeline.at(stroked_scene(InkFrom::strokes));
  const Image coverage = frame.raw(BufferName::coverage), lines = frame.raw(BufferName::lines);
  const Image strokes = frame.raw(BufferName::strokes);
  int inked = 0;
  for (int y = 0; y < lines.height_px; ++y) {
    for (int x = 0; x < lines.width_px; ++x) {
      ASSERT_NEAR(coverage.at(x, y), strokes.at(x, y, 3), 0.003F);
      ASSERT_EQ(lines.at(x, y), coverage.at(x, y) >= 0.5F ? 1.0F : 0.0F);
      inked += lines.at(x, y) > 0.0F ? 1 : 0;
    }
  }
  EXPECT_GT(inked, 500);
}

TEST(InkFrom, strokes_lie_over_the_shading) {
  Pipeline pipeline;
  Settings settings = stroked_scene(InkFrom::strokes);
  settings.ink.colour = {0.9F, 0.1F, 0.3F};
  const Frame frame = pipeline.at(settings);
  const Image final = frame.raw(BufferName::final), shaded = frame.raw(BufferName::shaded);
  const Image strokes = frame.raw(BufferName::strokes);
  for (int y = 0; y < final.height_px; ++y)
    for (int x = 0; x < final.width_px; ++x)
      for (int c = 0; c < 3; ++c) {
        const float hidden = strokes.at(x, y, 3);
        ASSERT_NEAR(final.at(x, y, c), glm::mix(shaded.at(x, y, c), settings.ink.colour[c], hidden), 1e-4F);
      }
}

TEST(InkFrom, both_have_all_the_ink_of_either) {
  Pipeline pipeline;
  for (const EdgeMethod method : {EdgeMethod::paper, EdgeMethod::dihedral}) {
    Settings settings = stroked_scene(InkFrom::both);
    settings.edges.method = method;
    const Image both = pipeline.at(settings).raw(BufferName::coverage);
    settings.ink.from = InkFrom::filter;
    const Image filter = pipeline.at(settings).raw(BufferName::coverage);
    settings.ink.from = InkFrom::strokes;
    const Image strokes = pipeline.at(settings).raw(BufferName::coverage);
    for (size_t i = 0; i < both.samples.size(); ++i)
      ASSERT_NEAR(both.samples[i], std::max(filter.samples[i], strokes.samples[i]), 0.003F);
  }
}

TEST(InkFrom, the_filter_runs_no_pass_of_strokes_and_strokes_none_of_the_filter) {
  Pipeline pipeline;
  pipeline.at(stroked_scene(InkFrom::filter)).draw(BufferName::final);
  for (const char* pass : {"object_curves", "strokes", "stroke_paint", "stroke_colours", "strokes_over"})
    EXPECT_EQ(pipeline.counts()[pass].runs, 0) << pass;
  Pipeline other;
  other.at(stroked_scene(InkFrom::strokes)).draw(BufferName::final);
  for (const char* pass : {"gradient", "combine", "ink"}) EXPECT_EQ(other.counts()[pass].runs, 0) << pass;
}

TEST(InkFrom, supersampled_strokes_are_those_of_the_pictures_own_size) {
  Pipeline pipeline;
  Settings settings = stroked_scene(InkFrom::strokes);
  settings.stroke.wobble = 2.0F;
  settings.stroke.hidden = true;
  const Picture once = pipeline.at(settings).picture(BufferName::strokes);
  settings.image.supersample = 4;
  const Picture finer = pipeline.at(settings).picture(BufferName::strokes);
  double difference = 0.0;
  for (size_t i = 0; i < once.samples.size(); ++i)
    difference += std::abs(int{once.samples[i]} - int{finer.samples[i]});
  EXPECT_LT(difference / static_cast<double>(once.samples.size()), 1.5);
  EXPECT_NE(once, finer);
}

TEST(InkFrom, surfaces_give_strokes_their_colours_on_both_sides_of_an_outline) {
  Settings settings = small_scene();
  settings.ink.from = InkFrom::strokes;
  settings.stroke.width = 6.0F;
  settings.stroke.colour = StrokeColour::material;
  settings.stroke.darken = 0.5F;
  const glm::vec3 expected = 0.5F * settings.models.at(0).material.colour;
  Pipeline pipeline;
  const Image strokes = pipeline.at(settings).raw(BufferName::strokes);
  int seen = 0;
  for (int y = 0; y < strokes.height_px; ++y)
    for (int x = 0; x < strokes.width_px; ++x) {
      if (strokes.at(x, y, 3) < 0.999F) continue;
      ++seen;
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(strokes.at(x, y, c), expected[c], 1e-4F) << x << ", " << y;
    }
  EXPECT_GT(seen, 100);
}

TEST(InkFrom, in_a_turning_view_paint_stays_where_it_was_on_the_line) {
  Settings settings = stroked_scene(InkFrom::strokes);
  Pipeline pipeline;
  const Frame first = pipeline.at(settings);
  const auto before = first.value<StrokesPass>();
  settings.camera.eye.x += 0.1F;
  const Frame second = pipeline.at(settings, first);
  const StrokeCarrying carried = carrying_between(*before, *second.value<StrokesPass>());
  settings.stroke.coherent = false;
  const StrokeCarrying anew = carrying_between(*before, *pipeline.at(settings, first).value<StrokesPass>());
  ASSERT_GT(carried.shifts_px.size(), 10U);
  EXPECT_LE(median_shift_px(carried), median_shift_px(anew));
}

TEST(StrokesDrawn, without_strokes_nothing_is_drawn) {
  for (const float sample : drawn_channels({16, 16, {}, {}}).samples) ASSERT_EQ(sample, 0.0F);
}

}  // namespace
}  // namespace inkbench
