// SPDX-License-Identifier: MIT
// The whole set of measures against their definitions written down plainly, and the conventions for empty
// maps, tiers and pooling.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "studies/measures/matching.h"
#include "tests/unit/measured.h"

namespace inkbench {
namespace {

/// Strokes 1 to 4 px wide in random directions.
LineMap random_strokes(int width, int height, int strokes, std::mt19937& random) {
  LineMap map(width, height);
  for (int i = 0; i < strokes; ++i) {
    double x = static_cast<double>(random() % width), y = static_cast<double>(random() % height);
    double angle = static_cast<double>(random() % 628) / 100;
    const int thickness = 1 + static_cast<int>(random() % 4);
    for (int step = 0; step < 60; ++step) {
      for (int dy = 0; dy < thickness; ++dy) {
        for (int dx = 0; dx < thickness; ++dx) {
          const int px = static_cast<int>(x) + dx, py = static_cast<int>(y) + dy;
          if (x >= 0 && y >= 0 && map.contains(px, py)) map.set(px, py);
        }
      }
      x += std::cos(angle);
      y += std::sin(angle);
      angle += (static_cast<double>(random() % 100) - 50) / 400;
    }
  }
  return map;
}

using Points = std::vector<Pixel>;

double nearest_px(const Pixel& from, const Points& to) {
  double best = std::numeric_limits<double>::infinity();
  for (const Pixel& pixel : to) best = std::min(best, std::hypot(pixel.x - from.x, pixel.y - from.y));
  return best;
}

double percentile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  const double rank = q * static_cast<double>(values.size() - 1);
  const auto low = static_cast<size_t>(rank);
  const size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (values[high] - values[low]) * (rank - static_cast<double>(low));
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

std::vector<double> distances(const Points& from, const Points& to, double limit) {
  std::vector<double> result;
  for (const Pixel& pixel : from) result.push_back(std::min(limit, nearest_px(pixel, to)));
  return result;
}

int count_parts(std::set<std::pair<int, int>> pixels) {
  int parts = 0;
  for (; !pixels.empty(); ++parts) {
    std::vector<std::pair<int, int>> stack = {*pixels.begin()};
    while (!stack.empty()) {
      const auto [x, y] = stack.back();
      stack.pop_back();
      if (pixels.erase({x, y}) == 0) continue;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) stack.push_back({x + dx, y + dy});
      }
    }
  }
  return parts;
}

double f1_from(int64_t matched, size_t predicted, size_t referenced) {
  const double precision = static_cast<double>(matched) / static_cast<double>(predicted);
  const double recall = static_cast<double>(matched) / static_cast<double>(referenced);
  return matched == 0 ? 0 : 2 * precision * recall / (precision + recall);
}

/// Everything that does not rest on the matching, on thinning or on polylines, from section 3's sentences.
struct ByDefinition {
  double chamfer, hd95, baddeley, breaks, mean_gap, ends, thickness, thickness_cov;
  int components;

  ByDefinition(const LineMap& ink, const Points& p, const Points& r, double tolerance) {
    constexpr double kAll = std::numeric_limits<double>::infinity();
    chamfer = (mean(distances(p, r, 10)) + mean(distances(r, p, 10))) / 2;
    hd95 = std::max(percentile(distances(p, r, kAll), 0.95), percentile(distances(r, p, kAll), 0.95));
    std::vector<double> squares, widths;
    Points background;
    for (int y = 0; y < ink.height_px(); ++y) {
      for (int x = 0; x < ink.width_px(); ++x) {
        const bool border = x < 2 || y < 2 || x >= ink.width_px() - 2 || y >= ink.height_px() - 2;
        if (border || !ink.at(x, y)) background.push_back({x, y});
        if (border) continue;
        const double difference =
            std::min(10.0, nearest_px({x, y}, p)) - std::min(10.0, nearest_px({x, y}, r));
        squares.push_back(difference * difference);
      }
    }
    baddeley = std::sqrt(mean(squares));
    std::set<std::pair<int, int>> missed, all;
    for (const Pixel& pixel : r) {
      if (nearest_px(pixel, p) > tolerance) missed.insert({pixel.x, pixel.y});
    }
    for (const Pixel& pixel : p) all.insert({pixel.x, pixel.y});
    const int gaps = count_parts(missed);
    breaks = 100.0 * gaps / static_cast<double>(r.size());
    mean_gap = gaps == 0 ? 0 : static_cast<double>(missed.size()) / gaps;
    components = count_parts(all);
    int end_pixels = 0;
    for (const auto& [x, y] : all) {
      int neighbours = -1;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) neighbours += all.count({x + dx, y + dy});
      }
      end_pixels += neighbours == 1;
    }
    ends = 100.0 * end_pixels / static_cast<double>(p.size());
    for (const Pixel& pixel : p) widths.push_back(2 * nearest_px(pixel, background) - 1);
    thickness = percentile(widths, 0.5);
    double variance = 0;
    for (const double width : widths) variance += (width - mean(widths)) * (width - mean(widths));
    thickness_cov = std::sqrt(variance / static_cast<double>(widths.size())) / mean(widths);
  }
};

Measured score(const LineMap& prediction, const LineMap& reference, double tolerance = 2) {
  return Measured(
      LinesToMeasure{.prediction = prediction, .reference = reference, .tolerance_px = tolerance});
}

void expect_equals_definition(const LineMap& prediction, const LineMap& reference, double tolerance) {
  const Measured m = score(prediction, reference, tolerance);
  const LineMap thin_p = counted_lines(prediction), thin_r = counted_lines(reference);
  const Points p = pixels_of(thin_p), r = pixels_of(thin_r);
  ASSERT_FALSE(p.empty() || r.empty());
  const ByDefinition d(prediction, p, r, tolerance);
  EXPECT_NEAR(m["chamfer"], d.chamfer, 1e-9);
  EXPECT_NEAR(m["hd95"], d.hd95, 1e-9);
  EXPECT_NEAR(m["baddeley"], d.baddeley, 1e-9);
  EXPECT_NEAR(m["breaks_per_100px"], d.breaks, 1e-9);
  EXPECT_NEAR(m["mean_gap_px"], d.mean_gap, 1e-9);
  EXPECT_EQ(m["components"], d.components);
  EXPECT_NEAR(m["ends_per_100px"], d.ends, 1e-9);
  EXPECT_NEAR(m["thickness_px"], d.thickness, 1e-9);
  EXPECT_NEAR(m["thickness_cov"], d.thickness_cov, 1e-9);
  EXPECT_EQ(m["predicted"], static_cast<int64_t>(p.size()));
  EXPECT_EQ(m["referenced"], static_cast<int64_t>(r.size()));
  EXPECT_EQ(m["matched"], matched_count(thin_p, thin_r, tolerance));
  EXPECT_NEAR(m["f1"], f1_from(m["matched"], p.size(), r.size()), 1e-12);
  EXPECT_NEAR(m["f1_t1"], f1_from(matched_count(thin_p, thin_r, 1), p.size(), r.size()), 1e-12);
  const double diagonal = 0.0075 * std::hypot(prediction.width_px(), prediction.height_px());
  EXPECT_NEAR(m["f1_diag"], f1_from(matched_count(thin_p, thin_r, diagonal), p.size(), r.size()), 1e-12);
}

TEST(Measures, equal_their_definitions_on_random_drawings) {
  std::mt19937 random(11);
  for (int round = 0; round < 24; ++round) {
    const int width = 40 + static_cast<int>(random() % 120), height = 30 + static_cast<int>(random() % 160);
    const LineMap prediction = random_strokes(width, height, 1 + round % 7, random);
    const LineMap reference = random_strokes(width, height, 1 + round % 4, random);
    SCOPED_TRACE(round);
    const double tolerances[] = {0, 1, 2, 12};
    expect_equals_definition(prediction, reference, tolerances[round % 4]);
  }
}

TEST(Measures, drawing_scored_against_itself_is_perfect) {
  std::mt19937 random(12);
  const LineMap map = random_strokes(200, 150, 6, random);
  const Measured m = score(map, map);
  EXPECT_EQ(m["matched"], m["predicted"]);
  EXPECT_EQ(m["precision"], 1);
  EXPECT_EQ(m["recall"], 1);
  EXPECT_EQ(m["f1"], 1);
  EXPECT_EQ(m["f1_t1"], 1);
  EXPECT_EQ(m["f1_diag"], 1);
  EXPECT_EQ(m["chamfer"], 0);
  EXPECT_EQ(m["hd95"], 0);
  EXPECT_EQ(m["baddeley"], 0);
  EXPECT_EQ(m["breaks_per_100px"], 0);
  EXPECT_FALSE(m.empty());
}

TEST(Measures, both_empty_is_perfect_and_marked) {
  const Measured m = score(LineMap(40, 30), LineMap(40, 30));
  EXPECT_TRUE(m.empty());
  EXPECT_EQ(m["precision"], 1);
  EXPECT_EQ(m["recall"], 1);
  EXPECT_EQ(m["f1"], 1);
  EXPECT_EQ(m["f1_t1"], 1);
  EXPECT_EQ(m["f1_diag"], 1);
  EXPECT_EQ(m["chamfer"], 0);
  EXPECT_EQ(m["baddeley"], 0);
  EXPECT_EQ(m["hd95"], 0);
  EXPECT_EQ(m["components"] + m["predicted"] + m["referenced"] + m["matched"], 0);
  EXPECT_EQ(m["breaks_per_100px"] + m["mean_gap_px"] + m["ends_per_100px"] + m["thickness_px"] +
                m["thickness_cov"] + m["ink"],
            0);
}

TEST(Measures, one_empty_is_zero_and_as_far_as_can_be) {
  LineMap map(60, 50);
  for (int x = 10; x < 50; ++x) map.set(x, 25);
  const LineMap none(60, 50);
  for (const Measured& m : {score(map, none), score(none, map)}) {
    EXPECT_FALSE(m.empty());
    EXPECT_EQ(m["precision"], 0);
    EXPECT_EQ(m["recall"], 0);
    EXPECT_EQ(m["f1"], 0);
    EXPECT_EQ(m["f1_t1"], 0);
    EXPECT_EQ(m["f1_diag"], 0);
    EXPECT_EQ(m["chamfer"], 10);
    EXPECT_EQ(m["baddeley"], 10);
    EXPECT_FALSE(m.has("hd95"));
  }
  EXPECT_EQ(score(none, map)["breaks_per_100px"], 100.0 / 40);
  EXPECT_EQ(score(none, map)["mean_gap_px"], 40);
  EXPECT_EQ(score(map, none)["breaks_per_100px"], 0);
}

TEST(Measures, smallest_images_are_all_border) {
  for (const int side : {1, 2, 3, 4}) {
    LineMap full(side, side);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) full.set(x, y);
    }
    EXPECT_TRUE(score(full, LineMap(side, side)).empty()) << side;
    EXPECT_EQ(score(full, full)["baddeley"], 0) << side;
  }
  LineMap dot(5, 5);
  dot.set(2, 2);
  EXPECT_EQ(score(dot, dot)["matched"], 1);
  EXPECT_EQ(score(dot, dot)["ink"], 1.0 / 25);
  EXPECT_EQ(score(dot, dot)["thickness_px"], 1);
  EXPECT_EQ(score(dot, LineMap(5, 5))["baddeley"], 10);
}

TEST(Measures, border_of_two_pixels_is_ignored_on_every_side) {
  LineMap frame(70, 40), inner(70, 40);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 70; ++x) {
      const int depth = std::min({x, y, 69 - x, 39 - y});
      frame.set(x, y, depth < 2);
      inner.set(x, y, depth == 2);
    }
  }
  EXPECT_TRUE(score(frame, frame).empty());
  EXPECT_EQ(score(inner, inner)["predicted"], inner.count() - 4);  // thinning takes the four corners
  EXPECT_EQ(score(inner, frame)["f1"], 0);
}

TEST(Measures, full_ink_is_scored) {
  LineMap full(300, 200);
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 300; ++x) full.set(x, y);
  }
  const Measured m = score(full, full);
  EXPECT_EQ(m["f1"], 1);
  EXPECT_EQ(m["components"], 1);
  EXPECT_NEAR(m["thickness_px"], 195, 4);
  EXPECT_EQ(m["ink"], 1) << "of the whole image, as in a study";
}

TEST(Measures, thickness_is_that_of_the_bar) {
  for (const int thickness : {1, 3, 5, 9, 25}) {
    LineMap bar(300, 60);
    for (int y = 20; y < 20 + thickness; ++y) {
      for (int x = 10; x < 290; ++x) bar.set(x, y);
    }
    EXPECT_EQ(score(bar, bar)["thickness_px"], thickness);
  }
}

TEST(Measures, second_tier_forgives_but_is_not_demanded) {
  LineMap wanted(100, 60), allowed(100, 60), drawn(100, 60);
  for (int x = 10; x < 90; ++x) {
    wanted.set(x, 10);
    allowed.set(x, 30);
    drawn.set(x, 10), drawn.set(x, 30), drawn.set(x, 50);
  }
  const Measured m = Measured(LinesToMeasure{.prediction = drawn, .reference = wanted, .allowed = &allowed});
  EXPECT_NEAR(m["precision"], 2.0 / 3, 1e-12);
  EXPECT_EQ(m["recall"], 1);
  EXPECT_EQ(m["matched"], 80);
  EXPECT_NEAR(m["f1"], 2 * (2.0 / 3) / (5.0 / 3), 1e-12);
  EXPECT_NEAR(score(drawn, wanted)["precision"], 1.0 / 3, 1e-12);
  const Measured undrawn =
      Measured(LinesToMeasure{.prediction = wanted, .reference = wanted, .allowed = &allowed});
  EXPECT_EQ(undrawn["f1"], 1);
}

TEST(Measures, tiers_that_coincide_forgive_no_doubled_line) {
  LineMap wanted(100, 60), doubled(100, 60);
  for (int x = 10; x < 90; ++x) wanted.set(x, 20), doubled.set(x, 19), doubled.set(x, 21);
  const Measured m = Measured(LinesToMeasure{.prediction = doubled, .reference = wanted, .allowed = &wanted});
  EXPECT_NEAR(m["precision"], 0.5, 1e-12);
}

TEST(Measures, recall_of_a_class_is_over_its_lines_alone) {
  LineMap drawn(100, 60), creases(100, 60);
  for (int x = 10; x < 90; ++x) creases.set(x, 20);
  for (int x = 10; x < 50; ++x) drawn.set(x, 21);
  const ShareCounts counts = tally_recall(drawn, creases, 1);
  EXPECT_EQ(counts.matched, 40);
  EXPECT_EQ(counts.total, 80);
}

TEST(Measures, pool_by_summing_counts) {
  std::mt19937 random(13);
  const LineMap p1 = random_strokes(120, 90, 4, random), r1 = random_strokes(120, 90, 3, random);
  LineMap p2(200, 100), r2(200, 100);
  for (int x = 20; x < 180; ++x) p2.set(x, 50), r2.set(x, 51);
  DrawingTally pooled = tally_maps({.prediction = p1, .reference = r1});
  const DrawingTally second = tally_maps({.prediction = p2, .reference = r2});
  const Measured m1(pooled), m2(second);
  pooled.add(second);
  const Measured m(pooled);
  EXPECT_EQ(m["matched"], m1["matched"] + m2["matched"]);
  EXPECT_DOUBLE_EQ(m["precision"], static_cast<double>(m1["matched"] + m2["matched"]) /
                                       static_cast<double>(m1["predicted"] + m2["predicted"]));
  EXPECT_DOUBLE_EQ(m["recall"], static_cast<double>(m1["matched"] + m2["matched"]) /
                                    static_cast<double>(m1["referenced"] + m2["referenced"]));
  EXPECT_DOUBLE_EQ(m["ink"], static_cast<double>(p1.count() + 160) / (120.0 * 90 + 200 * 100));
  const double inside1 = 116 * 86, inside2 = 196 * 96;
  EXPECT_NEAR(
      m["baddeley"],
      std::sqrt((m1["baddeley"] * m1["baddeley"] * inside1 + m2["baddeley"] * m2["baddeley"] * inside2) /
                (inside1 + inside2)),
      1e-12);
  EXPECT_EQ(m["components"], m1["components"] + m2["components"]);
  EXPECT_NE(m["f1"], (m1["f1"] + m2["f1"]) / 2);
}

TEST(Measures, empty_views_are_left_out_of_pooling) {
  LineMap map(60, 50);
  for (int x = 10; x < 50; ++x) map.set(x, 25);
  const LineTally one = tally_lines({.prediction = map, .reference = map});
  LineTally pooled;
  pooled.add(one);
  pooled.add(tally_lines({.prediction = LineMap(60, 50), .reference = LineMap(60, 50)}));
  EXPECT_EQ(Measured(pooled).json(), Measured(one).json());
  EXPECT_TRUE(Measured(LineTally{}).empty());
}

TEST(Measures, json_holds_every_key_once_and_null_where_there_is_no_value) {
  LineMap map(60, 50);
  for (int x = 10; x < 50; ++x) map.set(x, 25);
  const auto json = nlohmann::json::parse(score(map, LineMap(60, 50)).json());
  const std::set<std::string> expected = {
      "matched",     "predicted",  "referenced",     "precision",    "recall",        "f1",
      "f1_t1",       "f1_diag",    "chamfer",        "hd95",         "baddeley",      "breaks_per_100px",
      "mean_gap_px", "components", "ends_per_100px", "thickness_px", "thickness_cov", "jaggedness_px",
      "bias_px",     "ink",        "ink_px",         "empty"};
  std::set<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.insert(key);
  EXPECT_EQ(keys, expected);
  EXPECT_TRUE(json["hd95"].is_null());
  EXPECT_TRUE(json["jaggedness_px"].is_null());
  EXPECT_TRUE(json["predicted"].is_number_integer());
  EXPECT_EQ(json["predicted"], 40);
  EXPECT_EQ(json["empty"], false);
  EXPECT_EQ(json["chamfer"], 10);
}

TEST(Measures, far_lines_are_measured_untruncated) {
  LineMap left(400, 100), right(400, 100);
  for (int y = 20; y < 80; ++y) left.set(30, y), right.set(330, y);
  EXPECT_EQ(score(left, right)["hd95"], 300);
  EXPECT_EQ(score(left, right)["chamfer"], 10);
}

}  // namespace
}  // namespace inkbench
