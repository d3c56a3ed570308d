// SPDX-License-Identifier: MIT
// Width and coverage of placed lines against the exact share of each pixel, worked out on the CPU from the
// lines' own geometry.
#include "pipeline/passes/ink/coverage.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "pipeline/passes/ink/flood.h"
#include "pipeline/passes/ink/line_bits.h"
#include "pipeline/passes/ink/narrow_coverage.h"
#include "pipeline/passes/ink/seeds.h"
#include "pipeline/passes/placing/line_tiles.h"
#include "pipeline/passes/placing/placed_lines.h"
#include "tests/gl/checks.h"

namespace inkbench {
namespace {

constexpr int kSide = 48;

/// Placed lines by the points that they run through; y grows upwards, as in textures.
class PlacedImage {
 public:
  void add(glm::vec2 point, EdgeClass line_class = EdgeClass::crease, float share = 1.0F) {
    const int x = static_cast<int>(std::floor(point.x)), y = static_cast<int>(std::floor(point.y));
    const int row = kSide - 1 - y;
    set_placed(
        image_, x, row,
        {point.x - static_cast<float>(x) - 0.5F, point.y - static_cast<float>(y) - 0.5F, line_class, share});
    points_.push_back(point);
  }
  const Image& image() const { return image_; }
  const std::vector<glm::vec2>& points() const { return points_; }

 private:
  Image image_{kSide, kSide, 4};
  std::vector<glm::vec2> points_;
};

/// A wall at distance 2 that fills the image, or what `depth` says (share of far, row 0 on top).
GBuffer wall(const std::function<double(int, int)>& depth = [](int, int) { return 0.2; }) {
  return {to_texture(with_depth(Image(kSide, kSide, 3, 0.5F), make_image(kSide, kSide, depth))),
          to_texture(Image(kSide, kSide, 1, 1.0F))};
}

constexpr LensBlock kLens{10.0F, 0.02F, 0, 0};

/// By a flood, or where `narrow` by the way of narrow lines.
Image drawn(const PlacedImage& placed, const WidthParams& widths, int samples = 0,
            const GBuffer& gbuffer = wall(), bool narrow = false) {
  const GeneratedSources generated = generated_sources();
  const Texture lines = to_texture(placed.image());
  Image range(1, 1, 2);
  range.at(0, 0, 0) = range.at(0, 0, 1) = 2.0F;
  const Texture visible = to_texture(range);
  if (narrow) {
    const Texture tiles = LineTilesPass(generated).run(lines);
    const Texture bits = LineBitsPass(generated).run(widths, lines, tiles);
    return NarrowCoveragePass(generated).run(samples, widths, kLens, lines, bits, gbuffer).read(0, 1);
  }
  const Texture seeds = SeedsPass(generated).run(widths, kLens, lines, gbuffer, &visible);
  const Texture nearest = FloodPass(generated).run(widths, kLens, seeds, &visible);
  return CoveragePass(generated).run(samples, kLens, nearest, gbuffer).read(0, 1);
}

WidthParams of_width(float px) {
  WidthParams widths;
  widths.line.width = px;
  widths.of_class.fill(1.0F);
  widths.height_px = kSide;
  return widths;
}

float distance_to_chain(glm::vec2 here, const std::vector<glm::vec2>& points) {
  float nearest = glm::length(here - points.front());
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const glm::vec2 along = points[i + 1] - points[i];
    const float t = std::clamp(glm::dot(here - points[i], along) / glm::dot(along, along), 0.0F, 1.0F);
    nearest = std::min(nearest, glm::length(here - points[i] - t * along));
  }
  return nearest;
}

/// The share of a pixel (row 0 on top) nearer to the chain than half the width, by 32 x 32 points.
float exact_share(const std::vector<glm::vec2>& points, float width, int x, int row) {
  int inside = 0;
  for (int s = 0; s < 32 * 32; ++s) {
    const glm::vec2 here(static_cast<float>(x) + (static_cast<float>(s % 32) + 0.5F) / 32.0F,
                         static_cast<float>(kSide - 1 - row) + (static_cast<float>(s / 32) + 0.5F) / 32.0F);
    inside += distance_to_chain(here, points) <= 0.5F * width ? 1 : 0;
  }
  return static_cast<float>(inside) / (32.0F * 32.0F);
}

/// A line through the image's middle at an angle, a point in each column (or row, if it is steep).
PlacedImage straight_line(float degrees) {
  PlacedImage placed;
  const float slope = std::tan(degrees * 3.14159265F / 180.0F);
  for (int i = 6; i < kSide - 6; ++i) {
    const float along = static_cast<float>(i) + 0.5F, middle = 0.5F * kSide + 0.3F;
    if (std::abs(slope) <= 1.0F)
      placed.add({along, middle + slope * (along - 0.5F * kSide)});
    else
      placed.add({middle + (along - 0.5F * kSide) / slope, along});
  }
  return placed;
}

TEST(Coverage, is_the_exact_share_of_a_pixel_along_straight_lines_of_any_width_and_angle) {
  for (const float width : {0.4F, 1.0F, 1.5F, 4.0F, 11.0F}) {
    for (const float degrees : {0.0F, 7.0F, 30.0F, 45.0F, 70.0F, 90.0F, 120.0F}) {
      const PlacedImage placed = straight_line(degrees);
      const Image coverage = drawn(placed, of_width(width));
      double largest = 0;
      for (int y = 18; y < 30; ++y) {
        for (int x = 18; x < 30; ++x)
          largest = std::max<double>(largest,
                                     std::abs(coverage.at(x, y) - exact_share(placed.points(), width, x, y)));
      }
      EXPECT_LT(largest, 0.03) << width << " px at " << degrees;
    }
  }
}

PlacedImage circle(float radius) {
  PlacedImage placed;
  glm::ivec2 last(-1);
  for (int i = 0; i < 2000; ++i) {
    const float angle = 6.2831853F * static_cast<float>(i) / 2000.0F;
    const glm::vec2 point = glm::vec2(0.5F * kSide) + radius * glm::vec2(std::cos(angle), std::sin(angle));
    const glm::ivec2 pixel(std::floor(point.x), std::floor(point.y));
    if (pixel == last) continue;
    last = pixel;
    placed.add(point);
  }
  return placed;
}

/// The share of a pixel that a ring around the image's middle covers, by 32 x 32 points.
double ring_share(float radius, float width, int x, int row) {
  int inside = 0;
  for (int s = 0; s < 32 * 32; ++s) {
    const glm::vec2 here(static_cast<float>(x) + (static_cast<float>(s % 32) + 0.5F) / 32.0F,
                         static_cast<float>(kSide - 1 - row) + (static_cast<float>(s / 32) + 0.5F) / 32.0F);
    const float away = std::abs(glm::length(here - glm::vec2(0.5F * kSide)) - radius);
    inside += away <= 0.5F * width ? 1 : 0;
  }
  return inside / (32.0 * 32.0);
}

TEST(Coverage, has_a_quarter_of_the_aliased_error_at_most_around_a_circle) {
  constexpr float kRadius = 15.3F;
  for (const float width : {1.0F, 1.5F, 3.0F}) {
    const PlacedImage placed = circle(kRadius);
    const Image coverage = drawn(placed, of_width(width)), aliased = drawn(placed, of_width(width), 1);
    double error = 0, aliased_error = 0;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const double exact = ring_share(kRadius, width, x, y);
        error += std::pow(coverage.at(x, y) - exact, 2);
        aliased_error += std::pow(aliased.at(x, y) - exact, 2);
      }
    }
    EXPECT_LT(std::sqrt(error), 0.25 * std::sqrt(aliased_error)) << width << " px";
    EXPECT_GT(aliased_error, 1.0);
  }
}

TEST(Coverage, of_samples_is_what_antialiasing_is_measured_against) {
  const PlacedImage placed = straight_line(30.0F);
  const Image sampled = drawn(placed, of_width(2.0F), 8);
  for (int y = 18; y < 30; ++y) {
    for (int x = 18; x < 30; ++x)
      EXPECT_NEAR(sampled.at(x, y), exact_share(placed.points(), 2.0F, x, y), 0.04) << x << ", " << y;
  }
}

TEST(Coverage, of_narrow_lines_is_the_same_with_and_without_a_flood) {
  for (const float width : {0.3F, 1.0F, 1.5F, 2.7F, 4.0F}) {
    for (const float degrees : {0.0F, 19.0F, 45.0F, 63.0F, 90.0F, 151.0F}) {
      const PlacedImage placed = straight_line(degrees);
      EXPECT_TRUE(
          is_near(drawn(placed, of_width(width), 0, wall(), true), drawn(placed, of_width(width)), 0.011))
          << width << " px at " << degrees;
    }
  }
}

TEST(Coverage, lines_of_one_pixel_have_no_gaps) {
  for (float degrees = 0.0F; degrees < 180.0F; degrees += 11.0F) {
    const Image coverage = drawn(straight_line(degrees), of_width(1.0F));
    const bool is_steep = degrees > 45.0F && degrees < 135.0F;
    for (int i = 12; i < kSide - 12; ++i) {
      float most = 0;
      for (int j = 0; j < kSide; ++j) most = std::max(most, is_steep ? coverage.at(j, i) : coverage.at(i, j));
      EXPECT_GE(most, 0.5F) << degrees << " degrees at " << i;
    }
  }
}

/// Sum of a column's coverage: the width of a level line.
float width_in_column(const Image& coverage, int x) {
  float sum = 0;
  for (int y = 0; y < kSide; ++y) sum += coverage.at(x, y);
  return sum;
}

TEST(Coverage, widths_are_in_pixels_percent_or_world_units_and_of_a_class) {
  PlacedImage placed = straight_line(0.0F);
  WidthParams widths = of_width(5.0F);
  EXPECT_NEAR(width_in_column(drawn(placed, widths), 24), 5.0F, 0.02F);
  widths.line.unit = WidthUnit::percent;
  EXPECT_NEAR(width_in_column(drawn(placed, widths), 24), 0.05F * kSide, 0.02F);
  widths.line.unit = WidthUnit::world;
  widths.line.width = 0.2F;  // a pixel is 0.02 at distance 1, the wall is 2 away
  EXPECT_NEAR(width_in_column(drawn(placed, widths), 24), 0.2F / (0.02F * 2.0F), 0.02F);
  widths = of_width(5.0F);
  widths.of_class[static_cast<size_t>(EdgeClass::crease) - 1] = 0.5F;
  EXPECT_NEAR(width_in_column(drawn(placed, widths), 24), 2.5F, 0.02F);
  widths.of_class.fill(0.0F);
  EXPECT_EQ(width_in_column(drawn(placed, widths), 24), 0.0F);
}

TEST(Coverage, the_share_of_the_width_makes_lines_thinner) {
  PlacedImage placed;
  for (int x = 4; x < kSide - 4; ++x)
    placed.add({static_cast<float>(x) + 0.5F, 24.5F}, EdgeClass::crease, x < 24 ? 0.5F : 1.0F);
  const Image coverage = drawn(placed, of_width(6.0F));
  EXPECT_NEAR(width_in_column(coverage, 12), 3.0F, 0.05F);
  EXPECT_NEAR(width_in_column(coverage, 36), 6.0F, 0.05F);
}

TEST(Coverage, a_line_does_not_bleed_over_a_nearer_object) {
  // The left third is a box in front of the wall; a crease of the wall runs up along it.
  const auto depth = [](int x, int) { return x < 20 ? 0.1 : 0.2; };
  PlacedImage placed;
  for (int y = 4; y < kSide - 4; ++y) placed.add({21.5F, static_cast<float>(y) + 0.5F});
  const Image coverage = drawn(placed, of_width(8.0F), 0, wall(depth));
  for (int y = 10; y < kSide - 10; ++y) {
    EXPECT_EQ(coverage.at(19, y), 0.0F) << y;
    EXPECT_EQ(coverage.at(20, y), 1.0F) << y;
    EXPECT_GT(coverage.at(24, y), 0.9F) << y;
  }
}

TEST(Coverage, the_nearest_line_wins_by_where_it_ends) {
  PlacedImage placed;
  for (int y = 4; y < kSide - 4; ++y) {
    placed.add({14.5F, static_cast<float>(y) + 0.5F}, EdgeClass::silhouette);
    placed.add({20.5F, static_cast<float>(y) + 0.5F}, EdgeClass::crease);
  }
  WidthParams widths = of_width(2.0F);
  widths.of_class[static_cast<size_t>(EdgeClass::silhouette) - 1] = 4.0F;
  const Image coverage = drawn(placed, widths);
  EXPECT_NEAR(coverage.at(18, 24), 0.5F, 0.003F)
      << "the wide line ends there, though the thin one's middle is nearer";
  EXPECT_NEAR(coverage.at(19, 24), 0.5F, 0.003F) << "the thin one begins there";
}

}  // namespace
}  // namespace inkbench
