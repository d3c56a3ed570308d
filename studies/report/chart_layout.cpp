// SPDX-License-Identifier: MIT
#include "studies/report/chart_layout.h"

#include <algorithm>
#include <cmath>

#include "studies/report/lettering.h"

namespace inkbench {
namespace {

constexpr int kEdgePx = 30;
constexpr int kTitleLines = 3;
constexpr int kTickGapPx = 30;  // From an axis to its tick labels and from them to its name.
constexpr int kPanelGapPx = 56;
constexpr int kEntryGapPx = 44;  // Between entries of the legend.
constexpr int kMarkGapPx = 14;   // From a sample to its text.
constexpr int kLegendRoomPx = kChartWidthPx - 2 * kEdgePx + kEntryGapPx;
constexpr int kOnePanelPx = 400;  // Least height of the plot where there is one row of them.
constexpr int kRowOfPanelsPx = 270;

int width_of(const std::string& text, int size_px) {
  return text_width_px(text, size_px, Face::regular);
}

size_t columns_for(size_t panels) {
  return panels <= 3 ? panels : panels == 4 ? 2 : panels <= 9 ? 3 : 4;
}

/// Lines of a text that may not grow without end.
std::vector<std::string> lines_of(const std::string& text, int width_px, int size_px, int max_lines) {
  std::vector<std::string> lines = wrapped(text, width_px, size_px, Face::regular);
  if (std::ssize(lines) <= max_lines) return lines;
  lines.resize(static_cast<size_t>(max_lines));
  lines.back() = shortened(lines.back() + " ...", width_px, size_px);
  return lines;
}

class Layouter {
 public:
  explicit Layouter(const LayoutNeeds& needs) : needs_(needs) {
    layout_.columns = columns_for(needs.headings.size());
    rows_ = (needs.headings.size() + layout_.columns - 1) / layout_.columns;
  }

  ChartLayout run() {
    measure_widths();
    place_title();
    place_below();
    place_panels();
    place_axis_names();
    return std::move(layout_);
  }

 private:
  bool has_headings() const { return needs_.headings.size() > 1 || !needs_.headings.front().empty(); }

  void measure_widths() {
    const double name_px = needs_.y_label.empty() ? 0 : line_height_px(kLabelSizePx);
    left_ = kEdgePx + name_px + needs_.y_ticks_px + kTickGapPx;
    right_ = kChartWidthPx - kEdgePx - needs_.right_px - 12;
    const auto columns = static_cast<double>(layout_.columns);
    panel_width_ = (right_ - left_ - (columns - 1) * kPanelGapPx) / columns;
    short_headings_ =
        std::any_of(needs_.headings.begin(), needs_.headings.end(), [&](const std::string& value) {
          return !needs_.panel_label.empty() && width_of(heading(value), kLabelSizePx) > panel_width_;
        });
  }

  std::string heading(const std::string& value) const {
    return needs_.panel_label.empty() ? value : needs_.panel_label + ": " + value;
  }

  void place_title() {
    double y = kEdgePx;
    for (const std::string& line :
         lines_of(needs_.title, kChartWidthPx - 2 * kEdgePx, kTitleSizePx, kTitleLines)) {
      if (line.empty()) continue;
      y += line_height_px(kTitleSizePx);
      layout_.texts.push_back({line, kEdgePx, y - line_height_px(kTitleSizePx) / 2.0, kTitleSizePx,
                               TextAlign::left, false, "#111111"});
    }
    top_ = y + kLabelSizePx;
    if (!short_headings_) return;
    // No room for "vertex normals: smooth" over each panel: one line for all, and the values.
    layout_.texts.push_back({shortened(needs_.panel_label + ":", kChartWidthPx - 2 * kEdgePx, kLabelSizePx),
                             (left_ + right_) / 2, top_ + line_height_px(kLabelSizePx) / 2.0, kLabelSizePx,
                             TextAlign::center, false, "#555555"});
    top_ += line_height_px(kLabelSizePx) + 4;
  }

  /// What stands below the axes, from the bottom up; its places are known once the height is.
  void place_below() {
    std::vector<std::string> notes;
    for (const std::string& note : needs_.notes) {
      for (std::string& line : lines_of(note, kChartWidthPx - 2 * kEdgePx, kNoteSizePx, kTitleLines))
        notes.push_back(std::move(line));
    }
    const double notes_px = static_cast<double>(notes.size()) * line_height_px(kNoteSizePx);
    const double legend_px = legend_height();
    const double axis_px =
        needs_.x_ticks_px + kTickGapPx + (needs_.x_label.empty() ? 0 : line_height_px(kLabelSizePx) + 8);
    const double below_px = axis_px + legend_px + notes_px + kEdgePx;
    const double plot_px = rows_ == 1 ? kOnePanelPx : static_cast<double>(rows_) * kRowOfPanelsPx;
    const double heading_px = has_headings() ? static_cast<double>(rows_) * heading_height() : 0;
    layout_.height_px =
        std::max(kChartHeightPx, static_cast<int>(std::ceil(top_ + heading_px + plot_px + below_px)));
    bottom_ = layout_.height_px - below_px;
    double y = layout_.height_px - kEdgePx / 2.0 - notes_px;
    for (const std::string& line : notes) {
      layout_.texts.push_back({line, kEdgePx, y + line_height_px(kNoteSizePx) / 2.0, kNoteSizePx,
                               TextAlign::left, false, "#555555"});
      y += line_height_px(kNoteSizePx);
    }
    place_legend(bottom_ + axis_px);
  }

  static double heading_height() { return line_height_px(kLabelSizePx) + 8; }
  static double entry_height() { return line_height_px(kLabelSizePx) + 4; }
  static double legend_gap() { return 14; }

  int entry_width(const std::string& text) const {
    return kLegendMarkPx + kMarkGapPx + width_of(text, kLabelSizePx);
  }

  /// Whether all stand in one row, each with its own width; else they stand in columns of one width.
  bool legend_is_one_row() const {
    int sum = heading_width();
    for (const std::string& text : needs_.legend) sum += entry_width(text) + kEntryGapPx;
    return sum <= kLegendRoomPx;
  }

  size_t legend_columns() const {
    if (legend_is_one_row()) return needs_.legend.size();
    int widest = 1;
    for (const std::string& text : needs_.legend) widest = std::max(widest, entry_width(text) + kEntryGapPx);
    return std::clamp<size_t>(static_cast<size_t>(kLegendRoomPx / widest), 1, needs_.legend.size());
  }

  size_t legend_rows() const { return (needs_.legend.size() + legend_columns() - 1) / legend_columns(); }

  int heading_width() const {
    return needs_.legend_heading.empty() ? 0 : width_of(needs_.legend_heading, kLabelSizePx) + kEntryGapPx;
  }

  double legend_height() const {
    if (needs_.legend.empty()) return 0;
    const bool has_heading_row = !needs_.legend_heading.empty() && !legend_is_one_row();
    return static_cast<double>(legend_rows() + (has_heading_row ? 1 : 0)) * entry_height() + legend_gap();
  }

  void place_legend(double top) {
    if (needs_.legend.empty()) return;
    const bool one_row = legend_is_one_row();
    double y = top + legend_gap() + entry_height() / 2;
    double x = kEdgePx;
    if (!needs_.legend_heading.empty()) {
      layout_.texts.push_back({needs_.legend_heading, x, y, kLabelSizePx, TextAlign::left, false, "#555555"});
      one_row ? x += heading_width() : y += entry_height();
    }
    const size_t rows = legend_rows();
    const double pitch =
        static_cast<double>(kLegendRoomPx) / static_cast<double>((needs_.legend.size() + rows - 1) / rows);
    for (size_t i = 0; i < needs_.legend.size(); ++i) {
      if (!one_row) x = kEdgePx + pitch * static_cast<double>(i / rows);
      const double at_y = y + entry_height() * static_cast<double>(i % rows);
      const int room =
          one_row ? kChartWidthPx : static_cast<int>(pitch) - kEntryGapPx - kLegendMarkPx - kMarkGapPx;
      layout_.legend_marks.push_back({x, at_y});
      layout_.texts.push_back(
          {shortened(needs_.legend[i], room, kLabelSizePx), x + kLegendMarkPx + kMarkGapPx, at_y});
      x += entry_width(needs_.legend[i]) + kEntryGapPx;
    }
  }

  void place_panels() {
    const double gap = kLabelSizePx * 0.7;
    const double pitch = (bottom_ - top_ + gap) / static_cast<double>(rows_);
    const double heading_px = has_headings() ? heading_height() : 0;
    for (size_t i = 0; i < needs_.headings.size(); ++i) {
      const double x = left_ + static_cast<double>(i % layout_.columns) * (panel_width_ + kPanelGapPx);
      const double y = top_ + static_cast<double>(i / layout_.columns) * pitch;
      layout_.panels.push_back({x, x + panel_width_, y + heading_px, y + pitch - gap});
      if (!has_headings()) continue;
      const std::string text = short_headings_ ? needs_.headings[i] : heading(needs_.headings[i]);
      layout_.texts.push_back({shortened(text, static_cast<int>(panel_width_), kLabelSizePx),
                               x + panel_width_ / 2, y + heading_px / 2 - 4, kLabelSizePx,
                               TextAlign::center});
    }
  }

  void place_axis_names() {
    const double middle = (left_ + right_) / 2;
    const double below = bottom_ + needs_.x_ticks_px + kTickGapPx + line_height_px(kLabelSizePx) / 2.0;
    const int x_room = kChartWidthPx - 2 * kEdgePx;
    if (!needs_.x_label.empty()) {
      layout_.texts.push_back(
          {shortened(needs_.x_label, x_room, kLabelSizePx), middle, below, kLabelSizePx, TextAlign::center});
    }
    if (!needs_.y_label.empty()) {
      const int room = static_cast<int>(bottom_ - top_);
      layout_.texts.push_back({shortened(needs_.y_label, room, kLabelSizePx), kEdgePx + 6.0,
                               (top_ + bottom_) / 2, kLabelSizePx, TextAlign::center, true});
    }
  }

  const LayoutNeeds& needs_;
  ChartLayout layout_;
  size_t rows_ = 1;
  double top_ = 0, bottom_ = 0, left_ = 0, right_ = 0, panel_width_ = 0;
  bool short_headings_ = false;
};

}  // namespace

ChartLayout lay_out(const LayoutNeeds& needs) {
  return Layouter(needs).run();
}

std::string shortened(const std::string& text, int width_px, int size_px) {
  if (width_of(text, size_px) <= width_px) return text;
  std::string cut = text;
  while (!cut.empty() && width_of(cut + "...", size_px) > width_px) {
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xc0) == 0x80) cut.pop_back();
    if (!cut.empty()) cut.pop_back();
  }
  return cut + "...";
}

}  // namespace inkbench
