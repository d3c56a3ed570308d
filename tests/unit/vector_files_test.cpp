// SPDX-License-Identifier: MIT
// Strokes and curves as SVG files: groups, opacity, what is hidden, where they came from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/vectors/curves_svg.h"
#include "pipeline/vectors/strokes_svg.h"
#include "tests/unit/vector_support.h"

namespace inkbench {
namespace {

using testing::HasSubstr;
using testing::Not;

VectorPage small_page() {
  return {100, 80, {"rabbit", "box & co"}, {{"inkbench:settings", "a < b\n"}}};
}

Stroke of(Stroke stroke, CurveClass curve_class, int object_id, int covered = 0) {
  for (StrokePoint& point : stroke.points) point.curve_class = curve_class;
  stroke.object_id = object_id;
  stroke.covered = covered;
  return stroke;
}

Strokes few_strokes() {
  return {100,
          80,
          {of(loop_stroke(), CurveClass::silhouette, 1),
           of(stroke_through({{{5, 5}, 1.0F}, {{95, 5}, 1.0F}}), CurveClass::crease, 2),
           of(stroke_through({{{5, 70}, 1.0F}, {{95, 70}, 1.0F}}), CurveClass::crease, 2, 1)}};
}

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(StrokesSvg, class_and_object_are_groups_with_the_first_class_on_top) {
  const std::string svg = strokes_svg(few_strokes(), {}, small_page());
  const size_t crease = svg.find("<g id=\"crease\""), silhouette = svg.find("<g id=\"silhouette\"");
  EXPECT_LT(crease, silhouette);
  EXPECT_LT(crease, svg.find("<g id=\"crease-box___co\">"));
  EXPECT_LT(silhouette, svg.find("<g id=\"silhouette-rabbit\">"));
}

TEST(StrokesSvg, hidden_strokes_are_a_group_only_where_asked_for) {
  StrokeInk ink;
  EXPECT_THAT(strokes_svg(few_strokes(), ink, small_page()), Not(HasSubstr("hidden-crease")));
  ink.stroke.hidden = true;
  ink.stroke.hidden_opacity = 0.25F;
  const std::string svg = strokes_svg(few_strokes(), ink, small_page());
  EXPECT_THAT(svg, HasSubstr("inkscape:label=\"hidden\" opacity=\".25\""));
  EXPECT_LT(svg.find("<g id=\"hidden-crease-box___co\">"), svg.find("<g id=\"crease\""));
}

TEST(StrokesSvg, class_has_its_opacity_once_and_each_place_one_path) {
  StrokeInk ink;
  ink.classes[static_cast<size_t>(CurveClass::silhouette)].opacity = 0.5F;
  Strokes strokes = few_strokes();
  strokes.strokes.push_back(
      of(stroke_through({{{0, 40}, 2.0F}, {{99, 40}, 2.0F}}), CurveClass::silhouette, 1));
  const std::string svg = strokes_svg(strokes, ink, small_page());
  EXPECT_EQ(count_of(svg, "opacity"), 1);
  EXPECT_EQ(count_of(svg, "<path"), 2);
}

/// Two strokes that cross, of a class and of a later one, with their opacities.
std::string crossing_svg(float of_silhouette, float of_crease) {
  StrokeInk ink;
  ink.classes[static_cast<size_t>(CurveClass::silhouette)].opacity = of_silhouette;
  ink.classes[static_cast<size_t>(CurveClass::crease)].opacity = of_crease;
  const Strokes strokes{100,
                        80,
                        {of(stroke_through({{{50, 5}, 2.0F}, {{50, 75}, 2.0F}}), CurveClass::silhouette, 1),
                         of(stroke_through({{{5, 40}, 2.0F}, {{95, 40}, 2.0F}}), CurveClass::crease, 1)}};
  return strokes_svg(strokes, ink, small_page());
}

TEST(StrokesSvg, classes_of_one_opacity_have_it_together) {
  const std::string svg = crossing_svg(0.5F, 0.5F);
  EXPECT_THAT(svg, HasSubstr("<g id=\"strokes\" opacity=\".5\">"));
  EXPECT_EQ(count_of(svg, "opacity"), 1);
}

TEST(StrokesSvg, opaque_class_lies_over_a_fainter_one) {
  EXPECT_EQ(count_of(crossing_svg(1.0F, 0.5F), "<path"), 2);
}

TEST(StrokesSvg, faint_class_leaves_its_place_to_an_earlier_faint_one) {
  StrokeInk ink;
  for (StrokeClassParams& look : ink.classes) look.opacity = 0.5F;
  ink.classes[static_cast<size_t>(CurveClass::boundary)].opacity = 1.0F;
  const Strokes strokes{100,
                        80,
                        {of(stroke_through({{{50, 5}, 2.0F}, {{50, 75}, 2.0F}}), CurveClass::silhouette, 1),
                         of(stroke_through({{{5, 40}, 2.0F}, {{95, 40}, 2.0F}}), CurveClass::crease, 1),
                         of(stroke_through({{{5, 2}, 1.0F}, {{95, 2}, 1.0F}}), CurveClass::boundary, 1)}};
  EXPECT_EQ(count_of(strokes_svg(strokes, ink, small_page()), "<path"), 4);  // the crease in two parts
}

TEST(StrokesSvg, colours_of_the_shading_change_along_a_stroke) {
  StrokeInk ink;
  ink.stroke.colour = StrokeColour::shading;
  ink.stroke.darken = 0.0F;
  ink.surface = {Image(100, 80, 3, 1.0F), Image(100, 80, 1), Image(100, 80, 1)};
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 50; ++x) ink.surface.colours.at(x, y, 0) = 0.2F;
  }
  Strokes strokes{100, 80, {stroke_through({{{5, 40}, 2.0F}, {{30, 40}, 2.0F}, {{95, 40}, 2.0F}})}};
  const std::string svg = strokes_svg(strokes, ink, small_page());
  EXPECT_THAT(svg, HasSubstr("<path fill=\"#33ffff\""));
  EXPECT_THAT(svg, HasSubstr("<path fill=\"#ffffff\""));
}

TEST(SurfaceColours, stroke_beside_an_object_has_its_colour) {
  SurfaceColours surface{Image(40, 40, 3, 1.0F), Image(40, 40, 1, 9.0F), Image(40, 40, 1)};
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 20; ++x) {
      surface.colours.at(x, y, 1) = 0.5F;
      surface.depth.at(x, y) = 2.0F;
      surface.object_ids.at(x, y) = 1.0F;
    }
  }
  EXPECT_EQ(surface.at({21.5F, 20.0F}), glm::vec3(1.0F, 0.5F, 1.0F));
  EXPECT_EQ(surface.at({30.0F, 20.0F}), glm::vec3(1.0F));
}

TEST(StrokesSvg, parts_that_do_not_touch_are_paths_of_their_own) {
  Strokes strokes{100,
                  80,
                  {of(ring_stroke({40, 40}, 25), CurveClass::silhouette, 1),
                   of(ring_stroke({40, 40}, 10), CurveClass::silhouette, 1)}};
  const std::string svg = strokes_svg(strokes, {}, small_page());
  EXPECT_EQ(count_of(svg, "<path"), 2);
  EXPECT_EQ(count_of(svg, "M"), 4);  // each with its hole
}

TEST(StrokesSvg, stroke_through_two_classes_is_drawn_in_both) {
  Strokes strokes{100, 80, {stroke_through({{{5, 5}, 1.0F}, {{50, 5}, 1.0F}, {{95, 5}, 1.0F}})}};
  strokes.strokes[0].points[1].curve_class = CurveClass::crease;
  const std::string svg = strokes_svg(strokes, {}, small_page());
  EXPECT_THAT(svg, HasSubstr("<g id=\"silhouette\""));
  EXPECT_THAT(svg, HasSubstr("<g id=\"crease\""));
}

TEST(StrokesSvg, says_that_it_cannot_hold_paint) {
  StrokeInk ink;
  EXPECT_THAT(strokes_svg(few_strokes(), ink, small_page()), Not(HasSubstr("<desc>")));
  ink.stroke.brush = Brush::charcoal;
  EXPECT_THAT(strokes_svg(few_strokes(), ink, small_page()), HasSubstr("stroke.brush = charcoal cannot"));
}

TEST(VectorFiles, entries_are_read_as_they_were_written) {
  VectorPage page = small_page();
  page.about["inkbench:files"] = "a & b &lt; \"c\"\n> d";
  const std::string svg = strokes_svg(few_strokes(), {}, page);
  EXPECT_EQ(svg_entry(svg, "inkbench:files"), page.about["inkbench:files"]);
  EXPECT_EQ(svg_entry(svg, "inkbench:nothing"), "");
}

TEST(VectorFiles, carry_their_parameters_as_text) {
  for (const std::string& svg : {strokes_svg(few_strokes(), {}, small_page()),
                                 curves_svg({}, false, default_stroke_classes(), small_page())})
    EXPECT_THAT(svg, HasSubstr("<ink:text name=\"inkbench:settings\">a &lt; b\n</ink:text>"));
}

Curves few_curves() {
  Curves curves{100, 80, {}, {}};
  curves.curves.push_back(
      {.curve_class = CurveClass::silhouette, .object_id = 1, .points = {{1, 1}, {9, 1}}});
  curves.curves.push_back({.curve_class = CurveClass::crease, .points = {{1, 5}, {9, 5}, {9, 9}, {1, 5}}});
  curves.curves.push_back(
      {.curve_class = CurveClass::crease, .object_id = 2, .covered = 3, .points = {{1, 7}, {9, 7}}});
  return curves;
}

TEST(CurvesSvg, curve_is_a_path_in_the_group_of_its_class_and_object) {
  const std::string svg = curves_svg(few_curves(), false, default_stroke_classes(), small_page());
  EXPECT_THAT(svg, HasSubstr("<g id=\"silhouette-rabbit\">\n<path d=\"M1 1h8\"/>\n</g>"));
  EXPECT_THAT(svg, HasSubstr("stroke=\"#0072b2\">\n<path d=\"M1 5h8v4z\"/>\n</g>"));  // of no object
  EXPECT_THAT(svg, HasSubstr("stroke-width=\"1.5\""));
}

TEST(CurvesSvg, hidden_curves_are_dashed_and_say_what_covers_them_where_asked_for) {
  EXPECT_THAT(curves_svg(few_curves(), false, default_stroke_classes(), small_page()),
              Not(HasSubstr("hidden")));
  const std::string svg = curves_svg(few_curves(), true, default_stroke_classes(), small_page());
  EXPECT_THAT(svg, HasSubstr("opacity=\".6\" stroke-dasharray=\"5 3\""));
  EXPECT_THAT(svg, HasSubstr("<g id=\"hidden-crease-box___co\">\n<path data-covered=\"3\" d=\"M1 7h8\"/>"));
}

}  // namespace
}  // namespace inkbench
