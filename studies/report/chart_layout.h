// SPDX-License-Identifier: MIT
// Where things stand on a chart's paper: title, panels, legend, notes. In: the texts and how much room axes
// take. Out: places in px from the upper left corner; the paper grows downwards where it must.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace inkbench {

constexpr int kChartWidthPx = 1200;
constexpr int kChartHeightPx = 800;  ///< At least.
// Large for the paper, so that the chart reads at the width of a phone or of a journal's column.
constexpr int kTitleSizePx = 32;
constexpr int kLabelSizePx = 28;
constexpr int kTickSizePx = 26;
constexpr int kNoteSizePx = 22;
constexpr int kLegendMarkPx = 70;  ///< Length of a curve's sample.

enum class TextAlign { left, center, right };

struct PlacedText {
  std::string text;
  double x = 0, y = 0;  ///< Of its middle line.
  int size_px = kLabelSizePx;
  TextAlign align = TextAlign::left;
  bool upwards = false;
  std::string colour = "#222222";
};

struct ChartBox {
  double left = 0, right = 0, top = 0, bottom = 0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

struct LayoutNeeds {
  std::string title, x_label, y_label;
  std::string panel_label;  ///< What the headings are values of; empty where they speak for themselves.
  std::vector<std::string> headings;  ///< One for each panel; a single empty one: none.
  std::string legend_heading;
  std::vector<std::string> legend;  ///< Empty: none.
  std::vector<std::string> notes;
  int y_ticks_px = 0;  ///< Width of the widest tick label.
  int x_ticks_px = 0;  ///< Height of the tick labels.
  int right_px = 0;    ///< Kept free beside the panels.
};

struct ChartLayout {
  int height_px = kChartHeightPx;
  size_t columns = 1;  ///< Panels beside each other.
  std::vector<ChartBox> panels;
  std::vector<PlacedText> texts;                    ///< All but the ticks.
  std::vector<std::array<double, 2>> legend_marks;  ///< Left end of each curve's sample.

  bool is_leftmost(size_t panel) const { return panel % columns == 0; }
  bool is_lowest(size_t panel) const { return panel + columns >= panels.size(); }
};

ChartLayout lay_out(const LayoutNeeds& needs);

/// The text, cut at a character with "..." where it is wider.
std::string shortened(const std::string& text, int width_px, int size_px);

}  // namespace inkbench
