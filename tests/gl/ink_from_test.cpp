// SPDX-License-Identifier: MIT
// Strokes in colour, as ink, and in the final image.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/passes/strokes/stroke_colours.h"
#include "pipeline/passes/strokes/stroke_ink.h"
#include "pipeline/passes/strokes/strokes.h"
#include "pipeline/pipeline.h"
#include "pipeline/strokes/carry_along.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

/// Of an image of one tile, which has strokes.
Image marked_tile() {
  Image tile(1, 1, 1);
  tile.at(0, 0) = 1.0F;
  return tile;
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
  channels.tiles = to_texture(marked_tile());
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
  channels.tiles = to_texture(marked_tile());
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

TEST(InkFrom, paper_is_blank_but_for_the_ink) {
  Settings settings = stroked_scene(InkFrom::both);
  settings.ink.over = InkOver::paper;
  settings.ink.paper = {0.2F, 0.3F, 0.4F};
  Pipeline pipeline;
  const Image final = pipeline.at(settings).raw(BufferName::final);
  const Image coverage = pipeline.at(settings).raw(BufferName::coverage);
  int blank = 0;
  for (int y = 0; y < final.height_px; ++y)
    for (int x = 0; x < final.width_px; ++x) {
      if (coverage.at(x, y) > 0.0F) continue;
      ++blank;
      for (int c = 0; c < 3; ++c) ASSERT_EQ(final.at(x, y, c), settings.ink.paper[c]);
    }
  EXPECT_GT(blank, 5000);
}

TEST(InkFrom, paint_goes_on_from_a_frame_that_forgot_its_own_past) {
  const auto third_of = [](bool forgets) {
    Settings settings = stroked_scene(InkFrom::strokes);
    Pipeline pipeline;
    Frame frame = pipeline.at(settings);
    for (int i = 0; i < 2; ++i) {
      frame.value<StrokesPass>();
      settings.camera.eye.x += 0.1F;
      frame = pipeline.at(settings, forgets ? frame.without_past() : frame);
    }
    return frame.value<StrokesPass>();
  };
  const auto whole = third_of(false), cut = third_of(true);
  ASSERT_EQ(cut->courses.size(), whole->courses.size());
  for (size_t i = 0; i < cut->courses.size(); ++i)
    EXPECT_EQ(cut->courses[i].places, whole->courses[i].places) << i;
}

}  // namespace
}  // namespace inkbench
