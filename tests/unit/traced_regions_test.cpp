// SPDX-License-Identifier: MIT
// Shading as flat areas: colours, small regions, borders that neighbours share.
#include "pipeline/vectors/traced_regions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "pipeline/vectors/border_network.h"
#include "pipeline/vectors/regions.h"
#include "pipeline/vectors/regions_svg.h"
#include "tests/unit/vector_support.h"

namespace inkbench {
namespace {

using testing::ElementsAre;

template <class Value>
Image grey_picture(int width, int height, const Value& value) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int channel = 0; channel < 3; ++channel) image.at(x, y, channel) = value(x, y);
    }
  }
  return image;
}

ImageOf<int> numbers_of(const std::vector<std::string>& rows) {
  ImageOf<int> numbers(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 1);
  for (int y = 0; y < numbers.height_px; ++y) {
    for (int x = 0; x < numbers.width_px; ++x)
      numbers.at(x, y) = rows[static_cast<size_t>(y)][static_cast<size_t>(x)] - '0';
  }
  return numbers;
}

/// A light disc and a darker band on white, meeting each other and the edges.
float scene(int x, int y) {
  if (std::hypot(x + 0.5 - 40.0, y + 0.5 - 40.0) < 25.0) return 0.8F;
  return x + 2 * y > 140 ? 0.3F : 1.0F;
}

TEST(FlatColours, colours_apart_by_rounding_are_the_more_frequent_one) {
  const FlatPicture flat =
      flat_colours(grey_picture(10, 1,
                                [](int x, int) {
                                  return (x == 9 ? 61.0F : x < 5 ? 60.0F : 200.0F) / 255.0F;
                                }),
                   {}, 8);
  EXPECT_THAT(flat.colours, ElementsAre(Rgb{60, 60, 60}, Rgb{200, 200, 200}));
}

TEST(FlatColours, smooth_shading_becomes_the_stated_steps) {
  const Image shaded = grey_picture(256, 1, [](int x, int) { return static_cast<float>(x) / 255.0F; });
  const FlatPicture flat = flat_colours(shaded, {}, 8);
  EXPECT_EQ(flat.colours.size(), 8U);
  for (int x = 0; x < 256; ++x)
    EXPECT_NEAR(flat.colours[static_cast<size_t>(flat.numbers.at(x, 0))][0], x, 16.5);
}

TEST(FlatColours, smooth_object_leaves_a_flat_one_its_colours) {
  const Image shaded = grey_picture(300, 1, [](int x, int) {
    return static_cast<float>(x < 256 ? x : x < 280 ? 60 : 66) / 255.0F;
  });
  Image object_ids(300, 1, 1);
  for (int x = 256; x < 300; ++x) object_ids.at(x, 0) = 1.0F;
  const FlatPicture flat = flat_colours(shaded, object_ids, 4);
  EXPECT_THAT(flat.colours, testing::IsSupersetOf({Rgb{60, 60, 60}, Rgb{66, 66, 66}}));
}

TEST(Regions, small_one_takes_the_number_of_its_longest_border) {
  const Regions regions = without_small_regions(numbers_of({"00022", "01122", "00022"}), 3);
  EXPECT_EQ(regions.numbers, (std::vector<int>{0, 2}));
  EXPECT_EQ(regions.areas, (std::vector<int>{9, 6}));
}

TEST(Regions, pixels_that_touch_at_a_corner_alone_are_two) {
  EXPECT_EQ(find_regions(numbers_of({"01", "10"})).numbers, (std::vector<int>{0, 1, 1, 0}));
}

TEST(Regions, lone_small_one_stays) {
  EXPECT_EQ(without_small_regions(numbers_of({"00"}), 5).numbers.size(), 1U);
}

/// How often each border is used forwards and backwards.
std::map<std::pair<size_t, bool>, int> uses_of(const BorderNetwork& network) {
  std::map<std::pair<size_t, bool>, int> uses;
  for (const auto& rings : network.rings) {
    for (const BorderRing& ring : rings) {
      for (const BorderUse& use : ring) ++uses[{use.border, use.is_backwards}];
    }
  }
  return uses;
}

TEST(BorderNetwork, two_halves_have_three_borders_of_which_they_share_one) {
  const BorderNetwork network = border_network(numbers_of({"0011", "0011"}));
  EXPECT_EQ(network.borders.size(), 3U);
  EXPECT_EQ(uses_of(network).size(), 4U);
  EXPECT_THAT(network.rings, ElementsAre(ElementsAre(testing::SizeIs(2)), ElementsAre(testing::SizeIs(2))));
}

TEST(BorderNetwork, island_is_a_ring_of_its_own_within_the_other) {
  const BorderNetwork network = border_network(numbers_of({"0000", "0110", "0000"}));
  EXPECT_EQ(network.borders.size(), 2U);
  EXPECT_EQ(network.rings[0].size(), 2U);
  EXPECT_EQ(network.rings[1].size(), 1U);
}

TEST(BorderNetwork, each_side_of_a_border_is_used_once_by_the_region_on_its_right) {
  const Regions regions = find_regions(numbers_of({"0102", "1012", "0110", "2201"}));
  const BorderNetwork network = border_network(regions.region);
  size_t used = 0;
  for (const auto& [use, count] : uses_of(network)) {
    EXPECT_EQ(count, 1);
    ++used;
  }
  size_t at_the_edge = 0;
  for (const Border& border : network.borders) {
    const auto on_edge = [](const glm::ivec2& corner) {
      return corner.x == 0 || corner.x == 4 || corner.y == 0 || corner.y == 4;
    };
    at_the_edge += std::all_of(border.corners.begin(), border.corners.end(), on_edge) ? 1 : 0;
  }
  EXPECT_EQ(used, 2 * network.borders.size() - at_the_edge);
}

TEST(TracedRegions, neighbours_leave_no_gap_and_do_not_overlap) {
  const std::vector<TracedRegion> regions = traced_regions(grey_picture(80, 60, scene), {}, {});
  ASSERT_EQ(regions.size(), 3U);
  Image sum(80, 60, 1);
  for (const TracedRegion& region : regions) {
    std::vector<Ring> rings;
    for (const CubicPath& path : region.outlines) rings.push_back(flattened(path));
    const Image coverage = ring_coverage(rings, 80, 60);
    for (size_t i = 0; i < sum.samples.size(); ++i) sum.samples[i] += coverage.samples[i];
  }
  EXPECT_THAT(sum.samples, testing::Each(testing::FloatNear(1.0F, 1.0F / 64.0F + 1e-5F)));
}

TEST(TracedRegions, disc_is_a_few_smooth_curves_near_its_circle) {
  const Image shaded = grey_picture(
      80, 80, [](int x, int y) { return std::hypot(x + 0.5 - 40.0, y + 0.5 - 40.0) < 25.0 ? 0.5F : 1.0F; });
  const std::vector<TracedRegion> regions = traced_regions(shaded, {}, {});
  ASSERT_EQ(regions.size(), 2U);
  const CubicPath& circle = regions[1].outlines.at(0);
  EXPECT_LE(circle.pieces.size(), 6U);
  for (const glm::dvec2& point : flattened(circle))
    EXPECT_NEAR(glm::distance(point, {40.0, 40.0}), 25.0, 0.6);
}

TEST(TracedRegions, rectangle_has_its_corners_and_nothing_else) {
  const Image shaded =
      grey_picture(60, 60, [](int x, int y) { return x >= 10 && x < 45 && y >= 20 && y < 50 ? 0.5F : 1.0F; });
  const CubicPath rectangle = traced_regions(shaded, {}, {}).at(1).outlines.at(0);
  std::set<std::pair<double, double>> corners;
  for (const PathPiece& piece : rectangle.pieces) {
    EXPECT_TRUE(piece.is_line);
    corners.emplace(piece.end.x, piece.end.y);
  }
  EXPECT_THAT(corners, ElementsAre(testing::Pair(10, 20), testing::Pair(10, 50), testing::Pair(45, 20),
                                   testing::Pair(45, 50)));
}

TEST(TracedRegions, borders_of_the_image_stay_on_its_edges) {
  const Image shaded = grey_picture(60, 40, [](int x, int y) {
    return x + 1.3 * y < 12.0 ? 0.2F : x - 3 * y > 20 ? 0.6F : 1.0F;
  });
  Image sum(60, 40, 1);
  for (const TracedRegion& region : traced_regions(shaded, {}, {})) {
    for (const CubicPath& path : region.outlines) {
      const Image coverage = ring_coverage({flattened(path)}, 60, 40);
      for (size_t i = 0; i < sum.samples.size(); ++i) sum.samples[i] += coverage.samples[i];
    }
  }
  EXPECT_THAT(sum.samples, testing::Each(testing::FloatNear(1.0F, 1.0F / 64.0F + 1e-5F)));
}

TEST(TracedRegions, slanted_edge_is_a_line) {
  const Image shaded = grey_picture(100, 100, [](int x, int y) { return 10 * x > 300 + y ? 0.5F : 1.0F; });
  for (const TracedRegion& region : traced_regions(shaded, {}, {.sample_px = 0.5})) {
    for (const CubicPath& path : region.outlines) EXPECT_LE(path.pieces.size(), 4U);
  }
}

TEST(TracedRegions, finer_samples_are_as_large_as_they_are_said_to_be) {
  const std::vector<TracedRegion> regions =
      traced_regions(grey_picture(80, 60, scene), {}, {.sample_px = 0.5});
  double area = 0.0;
  for (const TracedRegion& region : regions) area += region.area;
  EXPECT_NEAR(area, 40.0 * 30.0, 1e-9);
  for (const CubicPath& path : regions[0].outlines) EXPECT_LE(path.start.x, 40.0 + 1e-9);
}

TEST(RegionsSvg, regions_are_drawn_large_ones_first_in_their_colours) {
  const std::string svg = regions_svg(traced_regions(grey_picture(80, 60, scene), {}, {}));
  const size_t white = svg.find("fill=\"#ffffff\""), disc = svg.find("fill=\"#cccccc\""),
               band = svg.find("fill=\"#4d4d4d\"");
  EXPECT_LT(white, disc);
  EXPECT_LT(disc, band);
  EXPECT_NE(band, std::string::npos);
}

}  // namespace
}  // namespace inkbench
