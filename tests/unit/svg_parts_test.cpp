// SPDX-License-Identifier: MIT
// The small parts of SVG files: texts, ids, numbers, path data.
#include "pipeline/vectors/svg_parts.h"

#include <gtest/gtest.h>

namespace inkbench {
namespace {

CubicPath line_path(const std::vector<glm::dvec2>& points, bool is_closed = false) {
  CubicPath path{points.front(), {}, is_closed};
  for (size_t i = 1; i < points.size(); ++i) path.pieces.push_back({{}, {}, points[i], true});
  return path;
}

std::string data_of(const CubicPath& path) {
  return path_data({&path, 1}, 2);
}

TEST(SvgParts, numbers_are_short) {
  EXPECT_EQ(svg_number(0.0, 2), "0");
  EXPECT_EQ(svg_number(-0.004, 2), "0");
  EXPECT_EQ(svg_number(0.5, 2), ".5");
  EXPECT_EQ(svg_number(-0.05, 2), "-.05");
  EXPECT_EQ(svg_number(12.0, 2), "12");
  EXPECT_EQ(svg_number(-3.256, 2), "-3.26");
}

TEST(SvgParts, text_keeps_within_its_element) {
  EXPECT_EQ(xml_text("a<b>&\"c\"\n"), "a&lt;b&gt;&amp;&quot;c&quot;\n");
  EXPECT_EQ(xml_text(std::string_view("\x01", 1)), "\\u0001");
}

TEST(SvgParts, id_holds_nothing_but_plain_characters) {
  EXPECT_EQ(id_part("my rabbit\"/é.2"), "my_rabbit____.2");
}

TEST(SvgParts, colours_are_bytes) {
  EXPECT_EQ(svg_colour({0.0F, 0.5F, 1.5F}), "#0080ff");
}

TEST(SvgParts, lines_are_relative_and_take_the_shortest_command) {
  EXPECT_EQ(data_of(line_path({{10, 20}, {10.5, 20}, {10.5, 18}, {11, 18.25}, {11.5, 18.5}})),
            "M10 20h.5v-2l.5 .25 .5 .25");
}

TEST(SvgParts, closed_path_leaves_its_last_line_to_z) {
  EXPECT_EQ(data_of(line_path({{0, 0}, {4, 0}, {4, 3}, {0, 0}}, true)), "M0 0h4v3z");
}

TEST(SvgParts, roundings_do_not_add_up) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i <= 300; ++i) points.emplace_back(i * 0.333333, 0.0);
  const std::string data = data_of(line_path(points));
  double x = 0.0;
  size_t at = data.find('h') + 1;
  while (at < data.size()) {
    size_t used = 0;
    x += std::stod(data.substr(at), &used);
    at += used + (at + used < data.size() && data[at + used] == ' ' ? 1 : 0);
  }
  EXPECT_NEAR(x, 100.0, 0.006);
}

TEST(SvgParts, curve_has_its_three_points_from_where_it_begins) {
  const CubicPath path{{1, 1}, {{{2, 1}, {3, 2}, {3, 3}, false}, {{3, 4}, {2, 5}, {1, 5}, false}}, false};
  EXPECT_EQ(data_of(path), "M1 1c1 0 2 1 2 2 0 1-1 2-2 2");
}

TEST(SvgParts, path_that_is_a_point_on_the_grid_is_left_out) {
  EXPECT_EQ(data_of(line_path({{1, 1}, {1.001, 1.002}})), "");
}

}  // namespace
}  // namespace inkbench
