// SPDX-License-Identifier: MIT
// The sanity matrix: a small synthetic drawing with one defect at a time. F alone cannot tell the defects
// apart; each must move its own measure and leave the others nearly where they were.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>

#include "tests/unit/measured.h"

namespace inkbench {
namespace {

constexpr int kSceneSide = 320;

/// Where a line runs, for x from 40 to 280: five of them, straight and wavy.
constexpr int kDrawnLines = 5;
constexpr double kFromX = 40, kToX = 280;

double height_of(int line, double x) {
  const double base = 40 + 60.0 * line;
  return line % 2 == 0 ? base + 0.1 * (x - kFromX) : base + 10 * std::sin((x - kFromX) / 40);
}

/// A round pen: every pixel whose centre is within half its width of the line.
void draw_line(LineMap& map, double width, const std::function<double(double)>& y_at,
               const std::function<bool(double)>& is_drawn) {
  for (double x = kFromX; x < kToX; x += 0.1) {
    if (!is_drawn(x)) continue;
    const double centre = y_at(x), reach = width / 2;
    for (int py = static_cast<int>(centre - reach); py <= static_cast<int>(centre + reach); ++py) {
      for (int px = static_cast<int>(x - reach); px <= static_cast<int>(x + reach); ++px) {
        if (std::hypot(px + 0.5 - x, py + 0.5 - centre) < reach) map.set(px, py);
      }
    }
  }
}

LineMap drawing(double width, const std::function<bool(int line, double x)>& is_drawn = {},
                const std::function<double(int line, double x)>& shift = {}) {
  LineMap map(kSceneSide, kSceneSide);
  for (int line = 0; line < kDrawnLines; ++line) {
    draw_line(
        map, width, [&](double x) { return height_of(line, x) + (shift ? shift(line, x) : 0); },
        [&](double x) { return !is_drawn || is_drawn(line, x); });
  }
  return map;
}

std::vector<Polyline> polylines() {
  std::vector<Polyline> lines;
  for (int line = 0; line < kDrawnLines; ++line) {
    Polyline polyline;
    for (double x = kFromX; x <= kToX; x += 4) {
      polyline.points.emplace_back(static_cast<float>(x), static_cast<float>(height_of(line, x)));
    }
    lines.push_back(polyline);
  }
  return lines;
}

Measured scored(const LineMap& prediction) {
  const LineMap reference = drawing(2);
  const std::vector<Polyline> lines = polylines();
  return Measured(LinesToMeasure{.prediction = prediction, .reference = reference, .polylines = lines});
}

Measured ideal() {
  return scored(drawing(3));
}

Measured short_gaps() {
  return scored(drawing(3, [](int, double x) { return std::fmod(x, 60) >= 12; }));
}

Measured line_lost() {
  return scored(drawing(3, [](int line, double) { return line != 2; }));
}

double wobble(int, double x) {
  return 1.2 * std::sin(2 * 3.14159265 * x / 10);
}

Measured jittered() {
  return scored(drawing(3, {}, wobble));
}

Measured specked() {
  LineMap map = drawing(3);
  for (int i = 0; i < 40; ++i) {  // 2 x 2 px, away from the lines
    const int x = 45 + i % 10 * 23, y = 70 + i / 10 * 60;
    for (int dy = 0; dy < 2; ++dy) {
      for (int dx = 0; dx < 2; ++dx) map.set(x + dx, y + dy);
    }
  }
  return scored(map);
}

Measured doubled() {
  return scored(united(drawing(3), drawing(3, {}, [](int, double) { return 7.0; })));
}

/// The names of the measures that differ from the ideal drawing's by more than a twentieth of its value, or
/// by more than the slack that the measure's unit allows.
std::map<std::string, double> moved(const Measured& defect) {
  const std::map<std::string, double> slack = {
      {"precision", 0.03}, {"recall", 0.03},       {"breaks_per_100px", 0.1}, {"mean_gap_px", 1},
      {"components", 0},   {"thickness_px", 0.5},  {"thickness_cov", 0.1},    {"jaggedness_px", 0.1},
      {"bias_px", 0.2},    {"ends_per_100px", 0.5}};
  const Measured good = ideal();
  std::map<std::string, double> result;
  for (const auto& [key, allowed] : slack) {
    const double change = defect[key] - good[key];
    if (std::abs(change) > allowed) result[key] = change;
  }
  return result;
}

std::string names(const std::map<std::string, double>& moved_measures) {
  std::string text;
  for (const auto& [name, change] : moved_measures) text += name + (change > 0 ? "+ " : "- ");
  return text;
}

TEST(MeasureSanity, ideal_drawing_scores_well_everywhere) {
  const Measured m = ideal();
  EXPECT_GT(m["precision"], 0.99);
  EXPECT_GT(m["recall"], 0.98);
  EXPECT_EQ(m["components"], kDrawnLines);
  EXPECT_EQ(m["breaks_per_100px"], 0);
  EXPECT_EQ(m["thickness_px"], 3);
  EXPECT_LT(m["jaggedness_px"], 0.35);
  EXPECT_NEAR(m["bias_px"], 0, 0.1);
}

TEST(MeasureSanity, short_gaps_move_breaks) {
  EXPECT_EQ(names(moved(short_gaps())),
            "breaks_per_100px+ components+ ends_per_100px+ mean_gap_px+ recall- ");
  EXPECT_GT(short_gaps()["breaks_per_100px"], 1.5);
  EXPECT_LT(short_gaps()["mean_gap_px"], 13);
}

TEST(MeasureSanity, lost_line_moves_the_mean_gap) {
  EXPECT_EQ(names(moved(line_lost())), "components- mean_gap_px+ recall- ");
  EXPECT_GT(line_lost()["mean_gap_px"], 200);
}

TEST(MeasureSanity, jitter_moves_jaggedness) {
  EXPECT_EQ(names(moved(jittered())), "jaggedness_px+ ");
  EXPECT_GT(jittered()["jaggedness_px"], 2 * ideal()["jaggedness_px"]);
}

TEST(MeasureSanity, specks_move_components) {
  EXPECT_EQ(names(moved(specked())), "components+ precision- ");
  EXPECT_GE(specked()["components"], kDrawnLines + 40);
}

TEST(MeasureSanity, doubled_lines_move_precision) {
  EXPECT_EQ(names(moved(doubled())), "components+ precision- ");
  EXPECT_LT(doubled()["precision"], 0.55);
  EXPECT_EQ(doubled()["components"], 2 * kDrawnLines);
}

TEST(MeasureSanity, thick_lines_move_thickness) {
  EXPECT_EQ(names(moved(scored(drawing(5)))), "thickness_px+ ");
}

TEST(MeasureSanity, shifted_lines_move_bias) {
  EXPECT_EQ(names(moved(scored(drawing(3, {}, [](int, double) { return 1.0; })))), "bias_px+ ");
}

TEST(MeasureSanity, one_number_cannot_tell_defects_apart) {
  EXPECT_NEAR(line_lost()["recall"], 0.8, 0.02);
  EXPECT_NEAR(short_gaps()["f1"], line_lost()["f1"], 0.01);
  EXPECT_GT(line_lost()["mean_gap_px"], 20 * short_gaps()["mean_gap_px"]);
}

}  // namespace
}  // namespace inkbench
