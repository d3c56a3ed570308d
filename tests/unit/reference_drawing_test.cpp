// SPDX-License-Identifier: MIT
// Maps, picture and SVG of reference lines.
#include "pipeline/lines/drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <glm/trigonometric.hpp>
#include <limits>
#include <set>

#include "pipeline/lines/class_pixels.h"
#include "tests/unit/reference_support.h"

namespace inkbench {
namespace {

using testing::HasSubstr;

ReferenceLines hand_made() {
  ReferenceLines lines{20, 10, {}, {}};
  lines.polylines.push_back(
      {LineClass::silhouette, 1, {{2.5F, 2.5F}, {6.5F, 2.5F}, {6.5F, 6.5F}, {2.5F, 2.5F}}});
  lines.polylines.push_back({LineClass::object, 2, {{10.0F, 0.0F}, {10.0F, 10.0F}}});
  lines.polylines.push_back({LineClass::ridge, 1, {{12.2F, 3.2F}, {18.2F, 3.2F}}});
  lines.whole_creases.push_back({LineClass::crease, 1, {{2.5F, 2.5F}, {6.5F, 2.5F}}});
  return lines;
}

std::vector<Pixel> pixels_of_line(const Polyline& line, int width = 20, int height = 10) {
  LineMap map(width, height);
  draw_line(line, map);
  return pixels_of(map);
}

TEST(ReferenceMaps, line_sets_the_pixels_that_hold_its_samples) {
  EXPECT_EQ(pixels_of_line({LineClass::silhouette, 1, {{2.5F, 3.2F}, {5.5F, 3.2F}}}),
            (std::vector<Pixel>{{2, 3}, {3, 3}, {4, 3}, {5, 3}}));
  EXPECT_EQ(pixels_of_line({LineClass::silhouette, 1, {{1.5F, 1.5F}, {4.5F, 4.5F}}}),
            (std::vector<Pixel>{{1, 1}, {2, 2}, {3, 3}, {4, 4}}));
}

TEST(ReferenceMaps, sample_between_pixels_belongs_to_the_larger_coordinate_inside_the_image) {
  EXPECT_EQ(pixels_of_line({LineClass::object, 1, {{3.0F, 0.0F}, {3.0F, 2.0F}}}),
            (std::vector<Pixel>{{3, 0}, {3, 1}, {3, 2}}));
  EXPECT_EQ(pixels_of_line({LineClass::object, 1, {{20.0F, 8.0F}, {20.0F, 10.0F}}}),
            (std::vector<Pixel>{{19, 8}, {19, 9}}));
}

TEST(ReferenceMaps, lines_have_no_gaps) {
  for (int i = 0; i < 90; ++i) {
    const float angle = glm::radians(static_cast<float>(i) * 4.0F);
    const std::vector<Pixel> pixels =
        pixels_of_line({LineClass::silhouette,
                        1,
                        {{50.3F, 50.7F}, {50.3F + 40 * std::cos(angle), 50.7F + 40 * std::sin(angle)}}},
                       100, 100);
    for (const Pixel& pixel : pixels) {
      const auto neighbours = std::count_if(pixels.begin(), pixels.end(), [&](const Pixel& other) {
        return !(other == pixel) && std::abs(other.x - pixel.x) <= 1 && std::abs(other.y - pixel.y) <= 1;
      });
      EXPECT_GE(neighbours, 1);
    }
    EXPECT_GE(pixels.size(), 28U);
  }
}

TEST(ReferenceMaps, a_pixel_may_be_of_several_classes) {
  const ReferenceLines lines = hand_made();
  EXPECT_TRUE(class_map(lines, LineClass::silhouette).at(4, 2));
  EXPECT_TRUE(class_map(lines, LineClass::crease).at(4, 2));
  EXPECT_FALSE(class_map(lines, LineClass::crease).at(6, 5));
  EXPECT_EQ(class_map(lines, LineClass::boundary).count(), 0);
}

TEST(ReferenceMaps, tiers_are_the_union_of_their_classes) {
  const ReferenceLines lines = hand_made();
  const LineMap first = tier_map(lines, {}, 1);
  EXPECT_EQ(first, united(class_map(lines, LineClass::silhouette), class_map(lines, LineClass::object)));
  EXPECT_EQ(tier_map(lines, {}, 2), class_map(lines, LineClass::ridge));
  EXPECT_EQ(tier_map(lines, {}, 2).count(), 7);
}

TEST(ReferenceMaps, first_four_classes_are_tier_1_unless_the_judge_says_otherwise) {
  std::vector<int> tiers;
  for (const LineClass line_class : kLineClasses) tiers.push_back(tier({}, line_class));
  EXPECT_EQ(tiers, (std::vector<int>{1, 1, 1, 1, 2, 2, 2}));
  JudgeParams judge;
  judge.crease = Demand::allowed;
  judge.valley = Demand::wanted;
  EXPECT_EQ(tier(judge, LineClass::crease), 2);
  EXPECT_EQ(tier(judge, LineClass::valley), 1);
}

TEST(ReferencePicture, has_a_colour_of_its_own_for_each_class) {
  std::set<std::array<uint8_t, 3>> colours;
  for (const LineClass line_class : kLineClasses) colours.insert(colour_of(line_class));
  EXPECT_EQ(colours.size(), 7U);
  EXPECT_FALSE(colours.contains({255, 255, 255}));
}

TEST(ReferencePicture, shows_earlier_classes_over_later_ones_on_white) {
  const Picture picture = draw_reference(hand_made());
  const auto colour = [&](int x, int y) {
    return std::array<uint8_t, 3>{picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)};
  };
  EXPECT_EQ(colour(0, 0), (std::array<uint8_t, 3>{255, 255, 255}));
  EXPECT_EQ(colour(6, 5), colour_of(LineClass::silhouette));
  EXPECT_EQ(colour(4, 2), colour_of_classes(0b101)) << "a silhouette over a crease";
  EXPECT_EQ(colour(10, 5), colour_of(LineClass::object));
  EXPECT_EQ(colour(15, 3), colour_of(LineClass::ridge));
}

TEST(ClassPixels, every_combination_of_classes_comes_back_from_its_colour_and_its_number) {
  std::set<std::array<uint8_t, 3>> colours;
  for (int classes = 0; classes < 128; ++classes) {
    const auto bits = static_cast<ClassBits>(classes);
    const std::array<uint8_t, 3> colour = colour_of_classes(bits);
    EXPECT_TRUE(colours.insert(colour).second) << classes;
    EXPECT_EQ(classes_of_colour(colour), bits);
    EXPECT_EQ(classes_of_number(static_cast<float>(classes)), bits);
  }
}

TEST(ClassPixels, a_colour_is_that_of_the_first_class_but_for_what_nobody_sees) {
  for (int classes = 1; classes < 128; ++classes) {
    const auto first = static_cast<size_t>(std::countr_zero(static_cast<unsigned>(classes)));
    const std::array<uint8_t, 3> colour = colour_of_classes(static_cast<ClassBits>(classes));
    for (int c = 0; c < 3; ++c)
      EXPECT_LE(std::abs(colour[c] - colour_of(kLineClasses[first])[c]), 3) << classes;
    if (std::has_single_bit(static_cast<unsigned>(classes))) {
      EXPECT_EQ(colour, colour_of(kLineClasses[first]));
    }
  }
}

TEST(ClassPixels, what_no_classes_have_is_known) {
  EXPECT_EQ(classes_of_colour({255, 255, 254}), std::nullopt);
  EXPECT_EQ(classes_of_colour({128, 128, 128}), std::nullopt);
  for (const float number : {-1.0F, 0.5F, 128.0F, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_EQ(classes_of_number(number), std::nullopt) << number;
}

TEST(ClassPixels, hold_the_maps_of_all_classes_and_tiers) {
  const ReferenceLines lines = hand_made();
  const Picture pixels = class_pixels(lines);
  for (const LineClass line_class : kLineClasses)
    EXPECT_EQ(class_map(pixels, line_class), class_map(lines, line_class)) << name_of(line_class);
  JudgeParams judge;
  judge.silhouette = Demand::allowed;  // lies over the crease, which is wanted
  for (const int wanted : {1, 2}) EXPECT_EQ(tier_map(pixels, judge, wanted), tier_map(lines, judge, wanted));
  EXPECT_EQ(tier_map(pixels, judge, 1).at(4, 2), true);
}

TEST(ReferenceSvg, has_a_group_for_each_class_and_a_path_for_each_polyline) {
  const std::string svg = reference_svg(hand_made());
  EXPECT_THAT(svg, HasSubstr("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"20\" height=\"10\""));
  for (const std::string_view name : kLineClassNames)
    EXPECT_THAT(svg, HasSubstr("<g id=\"" + std::string(name) + "\""));
  size_t paths = 0;
  for (size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) ++paths;
  EXPECT_EQ(paths, 3U);
  EXPECT_THAT(svg, HasSubstr("<path data-object=\"1\" d=\"M2.50 2.50L6.50 2.50L6.50 6.50Z\"/>"));
  EXPECT_THAT(svg, HasSubstr("<path data-object=\"2\" d=\"M10.00 0.00L10.00 10.00\"/>"));
  const size_t group = svg.find("<g id=\"ridge\"");
  EXPECT_LT(group, svg.find("M12.20 3.20"));
  EXPECT_LT(svg.find("M12.20 3.20"), svg.find("</g>", group));
  EXPECT_EQ(svg, reference_svg(hand_made()));
}

TEST(ReferenceSvg, nothing_gives_empty_groups) {
  const std::string svg = reference_svg({7, 5, {}, {}});
  EXPECT_EQ(svg.find("<path"), std::string::npos);
  EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 7 5\""));
}

}  // namespace
}  // namespace inkbench
