// SPDX-License-Identifier: MIT
// Editing ramps: stops keep their order, and each operation changes just what it says.
#include "app/workbench/ramp_edit.h"

#include <algorithm>
#include <cmath>

#include "pipeline/image/image_file.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

const glm::vec3 kRed(1, 0, 0), kGreen(0, 1, 0), kBlue(0, 0, 1);

Ramp three_stops(bool stepped = true) {
  return {{{0.25F, kRed, stepped}, {0.5F, kGreen, stepped}, {0.75F, kBlue, stepped}}, ""};
}

std::vector<float> positions(const Ramp& ramp) {
  std::vector<float> result;
  for (const RampStop& stop : ramp.stops) result.push_back(stop.position);
  return result;
}

float largest_difference(const Ramp& a, const Ramp& b) {
  float worst = 0;
  for (int i = 0; i <= 2000; ++i) {
    const float t = static_cast<float>(i) / 2000.0F;
    const glm::vec3 off = glm::abs(evaluate_ramp(a, t) - evaluate_ramp(b, t));
    worst = std::max({worst, off.x, off.y, off.z});
  }
  return worst;
}

TEST(RampEdit, a_moved_stop_takes_its_colour_along) {
  const TouchedRamp moved = move_stop(three_stops(), 1, 0.6F);
  EXPECT_EQ(moved.index, 1U);
  EXPECT_THAT(positions(moved.ramp), ElementsAre(0.25F, 0.6F, 0.75F));
  EXPECT_EQ(moved.ramp.stops[1].colour, kGreen);
}

TEST(RampEdit, a_moved_stop_passes_others_in_both_directions) {
  const TouchedRamp right = move_stop(three_stops(), 0, 0.9F);
  EXPECT_EQ(right.index, 2U);
  EXPECT_THAT(positions(right.ramp), ElementsAre(0.5F, 0.75F, 0.9F));
  EXPECT_EQ(right.ramp.stops[2].colour, kRed);
  const TouchedRamp left = move_stop(three_stops(), 2, 0.0F);
  EXPECT_EQ(left.index, 0U);
  EXPECT_EQ(left.ramp.stops[0].colour, kBlue);
}

TEST(RampEdit, moving_stays_within_the_ramp) {
  EXPECT_THAT(positions(move_stop(three_stops(), 0, -3.0F).ramp), ElementsAre(0.0F, 0.5F, 0.75F));
  EXPECT_THAT(positions(move_stop(three_stops(), 2, 7.0F).ramp), ElementsAre(0.25F, 0.5F, 1.0F));
  EXPECT_THAT(positions(move_stop(three_stops(), 0, std::nanf("")).ramp), ElementsAre(0.0F, 0.5F, 0.75F));
}

TEST(RampEdit, a_stop_at_anothers_place_stays_on_its_side) {
  EXPECT_EQ(move_stop(three_stops(), 0, 0.5F).index, 0U);
  EXPECT_EQ(move_stop(three_stops(), 1, 0.25F).index, 1U);
}

TEST(RampEdit, every_move_gives_a_ramp_that_settings_accept) {
  for (size_t i = 0; i < 3; ++i) {
    for (int step = -2; step <= 12; ++step) {
      const TouchedRamp moved = move_stop(three_stops(), i, static_cast<float>(step) / 10.0F);
      Settings settings = paper_settings();
      EXPECT_NO_THROW(set(settings, "ramp.diffuse", moved.ramp));
      EXPECT_EQ(moved.ramp.stops[moved.index].colour, three_stops().stops[i].colour);
    }
  }
}

TEST(RampEdit, a_new_stop_leaves_the_look_as_it_is) {
  Ramp mixed = three_stops();
  mixed.stops[1].stepped = false;
  for (const Ramp& ramp : {three_stops(true), three_stops(false), mixed}) {
    for (const float place : {0.0F, 0.1F, 0.25F, 0.3F, 0.6F, 0.75F, 0.9F, 1.0F}) {
      const TouchedRamp more = add_stop(ramp, place);
      ASSERT_THAT(more.ramp.stops, SizeIs(4));
      EXPECT_EQ(more.ramp.stops[more.index].position, place);
      EXPECT_LT(largest_difference(ramp, more.ramp), 1e-6F) << place;
      EXPECT_TRUE(
          std::is_sorted(more.ramp.stops.begin(), more.ramp.stops.end(),
                         [](const RampStop& a, const RampStop& b) { return a.position < b.position; }));
    }
  }
}

TEST(RampEdit, the_last_stop_cannot_be_removed) {
  Ramp ramp = three_stops();
  ramp = remove_stop(ramp, 1);
  EXPECT_THAT(positions(ramp), ElementsAre(0.25F, 0.75F));
  ramp = remove_stop(ramp, 0);
  ramp = remove_stop(ramp, 0);
  EXPECT_THAT(positions(ramp), ElementsAre(0.75F));
}

TEST(RampEdit, colours_and_steps_are_set) {
  EXPECT_EQ(set_stop_colour(three_stops(), 1, {0.5F, 2.0F, -1.0F}).stops[1].colour, glm::vec3(0.5F, 1, 0));
  EXPECT_FALSE(set_stop_stepped(three_stops(), 1, false).stops[1].stepped);
  EXPECT_TRUE(set_stop_stepped(three_stops(), 1, false).stops[0].stepped);
  EXPECT_EQ(set_all_stepped(three_stops(true), false), three_stops(false));
}

TEST(RampEdit, even_bands_are_as_many_as_asked_and_keep_both_ends) {
  const Ramp smooth{{{0.0F, glm::vec3(0), false}, {1.0F, glm::vec3(1), false}}, ""};
  const Ramp bands = even_bands(smooth, 5);
  EXPECT_THAT(positions(bands), ElementsAre(0.0F, 0.2F, 0.4F, 0.6F, 0.8F));
  EXPECT_EQ(evaluate_ramp(bands, 0.0F), glm::vec3(0));
  EXPECT_EQ(evaluate_ramp(bands, 0.99F), glm::vec3(1));
  EXPECT_EQ(evaluate_ramp(bands, 0.5F), glm::vec3(0.5F));
  EXPECT_THAT(even_bands(smooth, 1).stops, ElementsAre(RampStop{0.0F, glm::vec3(0.5F), true}));
  EXPECT_THAT(even_bands(smooth, -4).stops, SizeIs(1));
  EXPECT_THAT(even_bands(smooth, 1000).stops, SizeIs(kMaxBands));
}

TEST(RampEdit, the_papers_bands_stay_when_made_even) {
  const Ramp paper = paper_settings().ramp.diffuse;
  const Ramp bands = even_bands(paper, 4);
  for (size_t i = 0; i < 4; ++i) EXPECT_EQ(bands.stops[i].colour, paper.stops[i].colour) << i;
}

TEST(RampEdit, even_bands_go_on_along_the_colours_where_the_ramp_does_not) {
  const Ramp held{{{0.4F, glm::vec3(0), false}, {0.6F, glm::vec3(1), false}}, ""};
  const Ramp stepped{{{0.0F, glm::vec3(0), true}, {0.9F, glm::vec3(1), true}, {0.95F, glm::vec3(1), true}},
                     ""};
  for (const Ramp& ramp : {held, stepped}) {
    const Ramp bands = even_bands(ramp, 5);
    for (size_t i = 0; i < 5; ++i) EXPECT_FLOAT_EQ(bands.stops[i].colour.x, 0.25F * static_cast<float>(i));
  }
  const Ramp plain{{{0.2F, glm::vec3(0.5F), false}}, ""};
  EXPECT_EQ(even_bands(plain, 3).stops[2].colour, glm::vec3(0.5F));
}

class RampImage : public testing::Test {
 protected:
  /// One row, `colour(x)`.
  template <class Colour>
  Ramp image_ramp(int width_px, const Colour& colour) const {
    Image image(width_px, 1, 3);
    for (int x = 0; x < width_px; ++x) {
      for (int c = 0; c < 3; ++c) image.at(x, 0, c) = colour(x)[c];
    }
    write_exr(folder_.path() / "ramp.exr", image, {});
    return {{}, (folder_.path() / "ramp.exr").string()};
  }

  TemporaryFolder folder_;
};

/// Texels as the shader sees them.
float table_difference(const Ramp& a, const Ramp& b) {
  const std::vector<glm::vec3> left = ramp_table(a);
  const std::vector<glm::vec3> right = ramp_table(b);
  float worst = 0;
  for (size_t i = 0; i < left.size(); ++i) {
    const glm::vec3 off = glm::abs(left[i] - right[i]);
    worst = std::max({worst, off.x, off.y, off.z});
  }
  return worst;
}

TEST_F(RampImage, of_few_colours_becomes_exactly_its_steps) {
  const Ramp image = image_ramp(8, [](int x) { return x < 3 ? kRed : x < 4 ? kGreen : kBlue; });
  const Ramp stops = with_stops(image);
  EXPECT_THAT(stops.stops, ElementsAre(RampStop{0.0F, kRed, true}, RampStop{0.375F, kGreen, true},
                                       RampStop{0.5F, kBlue, true}));
  EXPECT_EQ(table_difference(image, stops), 0.0F);
}

TEST_F(RampImage, that_is_smooth_becomes_few_stops_within_half_a_level) {
  const Ramp image = image_ramp(1024, [](int x) {
    const float t = static_cast<float>(x) / 1023.0F;
    return glm::vec3(t, t * t, std::min(1.0F, 2 * t));
  });
  const Ramp stops = with_stops(image);
  EXPECT_LT(stops.stops.size(), 30U);
  EXPECT_LE(table_difference(image, stops), 0.5F / 255.0F + 1e-6F);
}

TEST_F(RampImage, of_noise_is_bounded_and_accepted) {
  uint32_t seed = 1;
  const auto noise = [&seed] {
    seed = seed * 1664525U + 1013904223U;
    return static_cast<float>(seed >> 8) / static_cast<float>(1U << 24U) * 3.0F - 1.0F;
  };
  const Ramp stops = with_stops(image_ramp(1024, [&](int) { return glm::vec3(noise(), noise(), noise()); }));
  EXPECT_EQ(stops.stops.size(), 64U);
  Settings settings = paper_settings();
  EXPECT_NO_THROW(set(settings, "ramp.diffuse", stops));
}

TEST_F(RampImage, that_is_missing_is_an_error) {
  EXPECT_THAT(error_of([&] {
                with_stops({{}, (folder_.path() / "none.png").string()});
              }),
              ::testing::HasSubstr("none.png"));
}

TEST(RampEdit, ramps_with_stops_or_nothing_need_no_image) {
  EXPECT_EQ(with_stops(three_stops()), three_stops());
  EXPECT_THAT(with_stops(Ramp{}).stops, SizeIs(2));
  EXPECT_LT(largest_difference(with_stops(Ramp{}), Ramp{}), 1e-6F);
}

}  // namespace
}  // namespace inkbench
