// SPDX-License-Identifier: MIT
// Charts up to gnuplot: which rows and points a chart shows, how axes and text are made, what the script
// says.
#include "studies/report/chart.h"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "studies/report/chart_axis.h"
#include "studies/report/chart_colours.h"
#include "studies/report/chart_data.h"
#include "studies/report/chart_layout.h"
#include "studies/report/chart_text.h"
#include "studies/report/lettering.h"
#include "tests/unit/chart_support.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// "x:y" for each point, "x:-" for a gap.
std::vector<std::string> points(const LineData& data, size_t curve = 0, size_t panel = 0) {
  std::vector<std::string> result;
  for (const CurvePoint& point : data.curves.at(curve).panels.at(panel))
    result.push_back(readable_number(point.x) + ":" + (std::isnan(point.y) ? "-" : readable_number(point.y)));
  return result;
}

std::vector<std::string> labels(const std::vector<ChartTick>& ticks) {
  std::vector<std::string> result;
  for (const ChartTick& tick : ticks) result.push_back(tick.label);
  return result;
}

TEST(ChartData, empty_and_unusable_values_are_gaps_and_failed_rows_are_left_out) {
  const CsvTable table = table_of("k,f1,error\n1,0.5,\n2,,\n3,nan,\n4,0.7,broken\n5,inf,\n6,0,\n");
  EXPECT_THAT(points(line_data(lines_chart(number("k")), table)),
              ElementsAre("1:0.5", "2:-", "3:-", "5:-", "6:0"));
}

TEST(ChartData, numbers_are_sorted_and_names_stand_in_order_of_appearance) {
  const CsvTable table = table_of("k,n,f1\n10,smooth,1\n9,flat,2\n100,nearest,3\n");
  const LineData by_number = line_data(lines_chart(number("k")), table);
  EXPECT_THAT(points(by_number), ElementsAre("9:2", "10:1", "100:3"));
  EXPECT_FALSE(by_number.is_sorted);
  const LineData by_name = line_data(lines_chart(names("n")), table);
  EXPECT_THAT(points(by_name), ElementsAre("1:1", "2:2", "3:3"));
  EXPECT_THAT(by_name.categories, ElementsAre("smooth", "flat", "nearest"));
}

TEST(ChartData, falling_rows_count_as_sorted) {
  EXPECT_TRUE(line_data(lines_chart(number("k")), table_of("k,f1\n3,1\n2,2\n1,3\n")).is_sorted);
}

TEST(ChartData, by_and_several_y_make_the_product_of_curves) {
  Chart chart = lines_chart(number("k"));
  chart.y.push_back(measured("recall"));
  chart.by = names("n");
  chart.panel = number("p");
  const LineData data =
      line_data(chart, table_of("k,n,p,f1,recall\n1,a,20,0.1,0.2\n1,b,20,0.3,0.4\n1,a,3,0.5,0.6\n"));
  EXPECT_THAT(data.panels, ElementsAre("3", "20"));
  std::vector<std::string> found;
  for (const LineCurve& curve : data.curves) found.push_back(curve.label);
  EXPECT_THAT(found, ElementsAre("f1, a", "f1, b", "recall, a", "recall, b"));
  EXPECT_THAT(points(data, 2, 0), ElementsAre("1:0.6"));
  EXPECT_THAT(points(data, 2, 1), ElementsAre("1:0.2"));
  EXPECT_THAT(points(data, 1, 0), IsEmpty());
}

TEST(ChartData, curves_of_different_units_name_them) {
  Chart chart = lines_chart(number("k"));
  chart.y.push_back({.name = "gap", .label = "gap", .unit = "px"});
  const CsvTable table = table_of("k,f1,gap\n1,0.1,2\n");
  EXPECT_EQ(line_data(chart, table).curves[1].label, "gap");
  chart.y_label = "";
  EXPECT_EQ(line_data(chart, table).curves[1].label, "gap (px)");
}

TEST(ChartData, where_keeps_the_rows_with_one_of_its_values) {
  Chart chart = lines_chart(number("k"));
  chart.where = {{names("n"), {"a", "c"}}};
  EXPECT_THAT(points(line_data(chart, table_of("k,n,f1\n1,a,1\n2,b,2\n3,c,3\n"))), ElementsAre("1:1", "3:3"));
}

TEST(ChartData, best_of_keeps_one_row_for_each_x_curve_and_panel) {
  const CsvTable table = table_of(
      "faces,k,n,f1\n100,1,a,0.2\n100,2,a,0.9\n100,3,a,\n200,1,a,0.8\n200,2,a,0.8\n100,5,b,0.1\n300,7,a,\n");
  Chart chart = lines_chart(number("faces"), "k");
  chart.by = names("n");
  chart.best_of = measured("f1");
  const LineData data = line_data(chart, table);
  EXPECT_THAT(points(data, 0), ElementsAre("100:2", "200:1")) << "the first of equals; none without a value";
  EXPECT_THAT(points(data, 1), ElementsAre("100:5"));
  chart.best_of_least = true;
  EXPECT_THAT(points(line_data(chart, table), 0), ElementsAre("100:1", "200:1"));
}

TEST(ChartData, zero_stands_apart_on_a_log_axis) {
  const CsvTable table = table_of("faces,f1\n0,0.9\n1000,0.5\n100,0.2\n");
  Chart chart = lines_chart(number("faces", Scale::log));
  const LineData below = line_data(chart, table);
  ASSERT_TRUE(below.zero_at.has_value());
  EXPECT_LT(*below.zero_at, 100);
  EXPECT_GT(*below.zero_at, 0);
  chart.x.zero = "as loaded";
  const LineData above = line_data(chart, table);
  EXPECT_GT(above.zero_at.value_or(0), 1000);
  EXPECT_EQ(above.curves[0].panels[0].back().y, 0.9);
  EXPECT_EQ(above.off_scale, 0U);
}

TEST(ChartData, a_log_axis_counts_what_it_cannot_show) {
  Chart chart = lines_chart(number("k"));
  chart.scale_y = Scale::log;
  const LineData data = line_data(chart, table_of("k,f1\n1,0\n2,-1\n3,2\n4,\n"));
  EXPECT_THAT(points(data), ElementsAre("1:-", "2:-", "3:2", "4:-"));
  EXPECT_EQ(data.off_scale, 2U);
  const LineData along_x = line_data(lines_chart(number("k", Scale::log)), table_of("k,f1\n-1,1\n,1\n2,1\n"));
  EXPECT_THAT(points(along_x), ElementsAre("2:1"));
  EXPECT_EQ(along_x.off_scale, 1U) << "a missing x is no value below 0";
}

TEST(ChartData, zero_that_means_something_else_comes_last) {
  Chart chart = lines_chart(number("k"));
  chart.by = number("faces");
  chart.by->zero = "as loaded";
  const LineData data = line_data(chart, table_of("k,faces,f1\n1,0,1\n1,500,1\n1,100,1\n"));
  EXPECT_EQ(data.curves[0].label, "100");
  EXPECT_EQ(data.curves[2].label, "as loaded");
}

TEST(ChartData, heat_map_tells_missing_cells_from_cells_without_a_value) {
  const HeatData data =
      heat_data(heat_chart(number("a"), names("n")), table_of("a,n,f1\n2,x,0.5\n1,x,\n2,y,0.25\n"));
  EXPECT_THAT(data.columns, ElementsAre("1", "2"));
  EXPECT_THAT(data.rows, ElementsAre("y", "x")) << "from the bottom up: names are read from the top";
  EXPECT_EQ(data.cell(0, 1, 1).value, 0.5);
  EXPECT_TRUE(data.cell(0, 1, 0).exists);
  EXPECT_TRUE(std::isnan(data.cell(0, 1, 0).value));
  EXPECT_FALSE(data.cell(0, 0, 0).exists);
  EXPECT_TRUE(data.has_gaps);
  EXPECT_EQ(data.low, 0.25);
  EXPECT_EQ(data.high, 0.5);
}

TEST(ChartData, too_much_for_one_chart_is_an_error) {
  std::string curves = "k,f1\n";
  for (int i = 0; i < 25; ++i) curves += std::to_string(i) + ",1\n";
  Chart chart = lines_chart(number("f1"));
  chart.by = number("k");
  EXPECT_EQ(error_of([&] { line_data(chart, table_of(curves)); }),
            "25 curves; at most 24; choose some with where");
  chart.panel = chart.by;
  chart.by.reset();
  EXPECT_THAT(error_of([&] { line_data(chart, table_of(curves)); }), StartsWith("25 panels; at most 24"));
  std::string cells = "a,b,f1\n";
  for (int i = 0; i < 201; ++i) cells += std::to_string(i) + "," + std::to_string(i) + ",1\n";
  EXPECT_THAT(error_of([&] { heat_data(heat_chart(number("a"), number("b")), table_of(cells)); }),
              StartsWith("40,401 cells in a heat map; at most 40,000"));
}

TEST(ChartText, numbers_read_well) {
  EXPECT_EQ(readable_number(69666), "69,666");
  EXPECT_EQ(readable_number(-1234567), "\u22121,234,567");
  EXPECT_EQ(readable_number(0.0010259856), "0.001026");
  EXPECT_EQ(readable_number(0.3), "0.3");
  EXPECT_EQ(readable_number(12.5), "12.5");
  EXPECT_EQ(readable_number(1e-7), "1e-07");
  EXPECT_EQ(readable_number(0), "0");
  EXPECT_EQ(readable_number(-0.004, 2), "0.00");
  EXPECT_EQ(readable_number(1234.5, 1), "1,234.5");
}

TEST(ChartText, fields_read_well) {
  ChartColumn faces = number("mesh.faces");
  faces.zero = "as loaded";
  EXPECT_EQ(readable_field(faces, "0"), "as loaded");
  EXPECT_EQ(readable_field(faces, "20000"), "20,000");
  EXPECT_EQ(readable_field(names("mesh"), "/home/a/b.off"), "b.off");
  EXPECT_EQ(readable_field(names("variant"), "20000"), "20000");
  EXPECT_EQ(readable_field(names("variant"), "a/b"), "a/b");
}

TEST(ChartText, units_are_named_once) {
  EXPECT_EQ(axis_text({.name = "a", .label = "chamfer distance", .unit = "px"}), "chamfer distance (px)");
  EXPECT_EQ(axis_text({.name = "a", .label = "triangles", .unit = "triangles"}), "triangles");
}

TEST(ChartText, literals_hold_nothing_that_gnuplot_acts_on) {
  EXPECT_EQ(literal("50% {a}_b^c $x"), "'50% {a}_b^c $x'");
  EXPECT_EQ(literal("it's"), "\"it\\047s\"");
  EXPECT_EQ(literal("a`date`@b\\n\"\t"), "\"a\\140date\\140\\100b\\134n\\042 \"");
  EXPECT_EQ(tick_literal("50%"), "'50%%'");
}

TEST(ChartAxis, log_ticks_are_round_and_separate_thousands) {
  const ChartAxis axis =
      horizontal_axis({.low = 100, .high = 50000, .scale = Scale::log, .length_px = 400, .size_px = 26});
  EXPECT_THAT(labels(axis.ticks), ElementsAre("100", "1,000", "10,000"));
  EXPECT_THAT(axis.minor, testing::Contains(2000.0));
  EXPECT_LT(axis.low, 100);
  EXPECT_GT(axis.high, 50000);
}

TEST(ChartAxis, short_log_ranges_get_further_ticks) {
  const ChartAxis axis =
      horizontal_axis({.low = 0.002, .high = 0.01, .scale = Scale::log, .length_px = 1000, .size_px = 26});
  EXPECT_THAT(labels(axis.ticks), ElementsAre("0.002", "0.005", "0.01"));
  const ChartAxis shortest_one =
      horizontal_axis({.low = 20, .high = 30, .scale = Scale::log, .length_px = 1000, .size_px = 26});
  EXPECT_THAT(labels(shortest_one.ticks), ElementsAre("20", "22", "24", "26", "28", "30"));
}

TEST(ChartAxis, labels_never_touch) {
  for (const Scale scale : {Scale::linear, Scale::log}) {
    for (int length_px = 120; length_px < 1200; length_px += 90) {
      for (const double high : {1.0, 3.0, 69666.0, 1e8}) {
        const ChartAxis axis = horizontal_axis(
            {.low = 0.001, .high = high, .scale = scale, .length_px = length_px, .size_px = 26});
        for (size_t i = 1; i < axis.ticks.size(); ++i) {
          const auto half = [&](const ChartTick& tick) {
            return text_width_px(tick.label, 26, Face::regular) / 2.0;
          };
          const double distance = (axis.part(axis.ticks[i].at) - axis.part(axis.ticks[i - 1].at)) * length_px;
          EXPECT_GT(distance, half(axis.ticks[i]) + half(axis.ticks[i - 1])) << axis.ticks[i].label;
        }
      }
    }
  }
}

TEST(ChartAxis, vertical_ends_are_ticks_and_zero_is_shown_where_it_costs_little) {
  const ChartAxis shares = vertical_axis({.low = 0.21, .high = 0.83, .length_px = 450, .size_px = 26});
  EXPECT_EQ(shares.low, 0);
  EXPECT_EQ(shares.high, 1);
  const ChartAxis near = vertical_axis({.low = 0.91, .high = 0.94, .length_px = 450, .size_px = 26});
  EXPECT_NEAR(near.low, 0.91, 1e-9);
  EXPECT_THAT(labels(near.ticks).front(), "0.910");
}

TEST(ChartAxis, asked_for_ends_are_kept) {
  const ChartAxis axis =
      vertical_axis({.low = 0.2, .high = 0.8, .from = 0.13, .to = 0.77, .length_px = 450, .size_px = 26});
  EXPECT_EQ(axis.low, 0.13);
  EXPECT_EQ(axis.high, 0.77);
  const ChartAxis beyond =
      vertical_axis({.low = 0.2, .high = 0.8, .from = 0.9, .length_px = 450, .size_px = 26});
  EXPECT_EQ(beyond.low, 0.9);
  EXPECT_GT(beyond.high, 0.9);
}

TEST(ChartAxis, a_single_value_has_room_around_it) {
  for (const Scale scale : {Scale::linear, Scale::log}) {
    for (const double value : {1e-9, 0.5, 1.0, 1e12}) {
      const ChartAxis axis =
          vertical_axis({.low = value, .high = value, .scale = scale, .length_px = 450, .size_px = 26});
      EXPECT_LT(axis.low, value);
      EXPECT_GT(axis.high, value);
      EXPECT_THAT(axis.ticks, Not(IsEmpty()));
    }
  }
}

TEST(ChartAxis, whole_numbers_get_whole_ticks) {
  const ChartAxis axis =
      horizontal_axis({.low = 0, .high = 3, .length_px = 1000, .size_px = 26, .is_whole = true});
  EXPECT_THAT(labels(axis.ticks), ElementsAre("0", "1", "2", "3"));
}

TEST(ChartAxis, what_stands_apart_is_named_behind_a_break) {
  const ChartAxis axis = horizontal_axis({.low = 100,
                                          .high = 10000,
                                          .scale = Scale::log,
                                          .apart = ChartTick{20000, "as loaded"},
                                          .length_px = 1000,
                                          .size_px = 26});
  EXPECT_EQ(axis.ticks.back().label, "as loaded");
  EXPECT_GT(axis.break_at.value_or(0), 10000);
  EXPECT_LT(axis.break_at.value_or(0), 20000);
  for (size_t i = 0; i + 1 < axis.ticks.size(); ++i) EXPECT_LT(axis.ticks[i].at, *axis.break_at);
}

TEST(ChartAxis, long_names_are_turned_and_many_numbers_thinned) {
  EXPECT_FALSE(category_axis({"a", "b"}, true, 900, 26).is_turned);
  EXPECT_TRUE(
      category_axis({"a long name of a variant", "another long name of a variant"}, true, 500, 26).is_turned);
  const std::vector<std::string> many(500, "0.0125");
  const ChartAxis thinned = category_axis(many, false, 900, 26);
  EXPECT_FALSE(thinned.is_turned);
  EXPECT_LT(thinned.ticks.size(), 12U);
  EXPECT_GT(thinned.ticks.size(), 5U);
}

double luminance(const std::string& colour) {
  const auto part = [&](size_t at) {
    return std::pow(std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0, 2.2);
  };
  return 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5);
}

TEST(ChartColours, order_survives_in_grey) {
  for (const size_t count : {2U, 3U, 8U, 24U}) {
    const std::vector<std::string> colours = curve_colours(count);
    for (size_t i = 1; i < count; ++i) EXPECT_GT(luminance(colours[i]), luminance(colours[i - 1]));
    EXPECT_LT(luminance(colours.back()), 0.45) << "still strong enough on white";
  }
  const std::vector<std::string> heat = heat_colours();
  for (size_t i = 1; i < heat.size(); ++i) EXPECT_LT(luminance(heat[i]), luminance(heat[i - 1]) - 0.01);
}

TEST(ChartLayout, everything_stands_on_the_paper) {
  LayoutNeeds needs{
      .title = std::string(300, 'T') + " and more", .x_label = "x", .y_label = std::string(200, 'y')};
  for (int i = 0; i < 15; ++i) needs.headings.push_back("panel " + std::to_string(i));
  needs.panel_label = "a panel";
  for (int i = 0; i < 24; ++i)
    needs.legend.push_back("curve " + std::string(static_cast<size_t>(i) * 5, 'c'));
  needs.notes = {"a note"};
  needs.y_ticks_px = 90;
  const ChartLayout layout = lay_out(needs);
  ASSERT_EQ(layout.panels.size(), 15U);
  for (const ChartBox& box : layout.panels) {
    EXPECT_GT(box.width(), 100);
    EXPECT_GT(box.height(), 150);
    EXPECT_LE(box.right, kChartWidthPx);
    EXPECT_LE(box.bottom, layout.height_px);
  }
  EXPECT_EQ(layout.legend_marks.size(), 24U);
  for (const PlacedText& text : layout.texts) {
    const double width = text.upwards ? 0 : text_width_px(text.text, text.size_px, Face::regular);
    const double left = text.x - (text.align == TextAlign::center ? width / 2 : 0);
    EXPECT_GE(left, 0) << text.text;
    EXPECT_LE(left + width, kChartWidthPx) << text.text;
    EXPECT_LT(text.y, layout.height_px) << text.text;
  }
}

TEST(ChartLayout, the_legend_stands_below_the_panels) {
  LayoutNeeds needs{.title = "T", .x_label = "x", .headings = {""}, .legend = {"a", "b"}, .x_ticks_px = 26};
  const ChartLayout layout = lay_out(needs);
  EXPECT_EQ(layout.height_px, kChartHeightPx);
  for (const auto& [x, y] : layout.legend_marks) EXPECT_GT(y, layout.panels[0].bottom + 60);
}

TEST(ChartScript, plain_tables_are_read_from_the_file) {
  Chart chart = lines_chart(number("k"));
  chart.by = names("n");
  const std::string script = chart_script(chart, table_of("k,n,f1,error\n1,a,0.123,\n2,a,0.4,\n1,b,0.5,\n"));
  EXPECT_THAT(script, HasSubstr("data = folder.'../data.csv'"));
  EXPECT_THAT(script, HasSubstr("strcol('n') eq 'a' && strcol('error') eq ''"));
  EXPECT_THAT(script, Not(HasSubstr("0.123"))) << "the numbers stay in the table";
}

TEST(ChartScript, rows_that_gnuplot_cannot_pick_stand_in_the_script) {
  Chart chart = lines_chart(number("k"));
  const auto holds_data = [&](const std::string& table) {
    const std::string script = chart_script(chart, table_of(table));
    return script.find("<< END") != std::string::npos && script.find("data.csv'") == std::string::npos;
  };
  EXPECT_FALSE(holds_data("k,n,f1,error\n1,a,0.5,\n2,b,0.5,\n"));
  EXPECT_TRUE(holds_data("k,n,f1,error\n2,a,0.5,\n1,b,0.5,\n3,a,0.1,\n")) << "not sorted";
  EXPECT_TRUE(holds_data("k,n,f1,error\n1,\"a \"\"b\"\"\",0.5,\n")) << "quotes shift gnuplot's columns";
  EXPECT_TRUE(holds_data("k,n,f1,error\n1,a\\b,0.5,\n"));
  chart.x = names("n");
  EXPECT_TRUE(holds_data("k,n,f1,error\n1,\"a, b\",0.5,\n")) << "a text with a comma ends there";
  EXPECT_TRUE(holds_data("k,n,f1,error\n1, a,0.5,\n"));
  chart = lines_chart(number("k"));
  chart.best_of = measured("f1");
  EXPECT_TRUE(holds_data("k,n,f1,error\n1,a,0.5,\n"));
}

TEST(ChartScript, the_same_table_gives_the_same_script) {
  const CsvTable table = table_of("a,b,f1,error\n1,1,0.5,\n2,1,0.25,\n1,2,,\n2,2,0.75,\n");
  for (const Chart& chart : {lines_chart(number("a"), "f1"), heat_chart(number("a"), number("b"))})
    EXPECT_EQ(chart_script(chart, table), chart_script(chart, table));
}

TEST(ChartCheck, cells_at_the_same_place_are_told_before_anything_is_drawn) {
  const CsvTable planned = table_of("cell,a,b,f1\n1,1,1,\n2,2,1,\n3,1,2,\n4,2,2,\n");
  Chart chart = lines_chart(number("a"));
  EXPECT_EQ(error_of([&] { check_chart(chart, planned); }),
            "cells 1 and 3 stand at the same place (a = 1); tell them apart with by or panel, or choose with "
            "where or "
            "best_of");
  chart.best_of = measured("f1");
  check_chart(chart, planned);
  chart.best_of.reset();
  chart.by = number("b");
  check_chart(chart, planned);
  chart.by.reset();
  chart.where = {{number("b"), {"2"}}};
  check_chart(chart, planned);
  chart.where = {{number("b"), {"3"}}};
  EXPECT_THAT(error_of([&] { check_chart(chart, planned); }), StartsWith("no cell passes where"));
}

}  // namespace
}  // namespace inkbench
