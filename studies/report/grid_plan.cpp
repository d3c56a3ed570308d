// SPDX-License-Identifier: MIT
#include "studies/report/grid_plan.h"

#include <algorithm>
#include <cassert>

#include "studies/report/grid_metrics.h"

namespace inkbench {
namespace {

constexpr std::array<uint8_t, 3> kTitleColour = {17, 17, 17};
constexpr std::array<uint8_t, 3> kTextColour = {34, 34, 34};
constexpr std::array<uint8_t, 3> kSubtitleColour = {102, 102, 102};

/// The part of both axes on one sheet, half open.
struct Part {
  int page = 0;
  int first_column = 0, end_column = 0;
  int first_row = 0, end_row = 0;
  std::string name;  ///< "part 2 of 3", or "".
};

/// Places everything of one sheet.
class SheetMaker {
 public:
  SheetMaker(const GridLayout& layout, const GridMetrics& metrics, const Part& part)
      : layout_(layout), m_(metrics), part_(part) {}

  GridSheet make() {
    sheet_.width_px = m_.width_px;
    sheet_.page = part_.page;
    place_header();
    m_.counts.flow ? place_flow() : place_matrix();
    return std::move(sheet_);
  }

 private:
  enum class Align { left, centre, right };

  void place_line(const std::string& text, int x, int top, const TextStyle& style) {
    sheet_.lines.push_back({text, style, x, top + baseline_px(style.size_px), false});
  }

  /// Lines one below the other; `x` is the left, middle or right of all.
  void place_lines(const std::vector<std::string>& lines, int x, int top, const TextStyle& style,
                   Align align) {
    for (const std::string& line : lines) {
      const int width = text_width_px(line, style.size_px, style.face);
      const int left = align == Align::left ? x : align == Align::right ? x - width : x - width / 2;
      place_line(line, left, top, style);
      top += line_height_px(style.size_px);
    }
  }

  void place_header() {
    const TextStyle title{m_.title.size_px, Face::bold, kTitleColour};
    place_lines(block_lines(layout_.title, m_.title, Face::bold), m_.margin_px, m_.margin_px, title,
                Align::left);
    int top = m_.margin_px + m_.title.height_px;
    if (m_.title.height_px > 0) top += m_.body_px / 4;
    const TextStyle subtitle{m_.subtitle.size_px, Face::regular, kSubtitleColour};
    const std::string text = subtitle_text(layout_, part_.page, part_.name);
    place_lines(block_lines(text, m_.subtitle, Face::regular), m_.margin_px, top, subtitle, Align::left);
  }

  TextStyle value_style() const { return {m_.value_px, Face::regular, kTextColour}; }

  /// A column's value above its cell, its last line next to `bottom`.
  void place_column_value(const std::string& value, int slot_left, int bottom) {
    const int line_px = line_height_px(m_.value_px), gap = m_.value_px / 3;
    const int room = std::max(1, (m_.column_values_height_px - gap) / line_px);
    const auto lines = block_lines(value, {m_.value_px, m_.value_width_px(), room, 0}, Face::regular);
    const int top = bottom - gap - static_cast<int>(lines.size()) * line_px;
    place_lines(lines, slot_left + m_.slot_width_px / 2, top, value_style(), Align::centre);
  }

  void place_column_label(const std::string& label, int columns, int bottom) {
    if (label.empty()) return;
    const TextStyle style{m_.column_label.size_px, Face::regular, kTextColour};
    const int width = columns * (m_.slot_width_px + m_.gutter_px) - m_.gutter_px;
    TextBlock block = m_.column_label;
    block.width_px = std::min(block.width_px, std::max(width, m_.width_px - 2 * m_.margin_px));
    const std::vector<std::string> lines = block_lines(label, block, Face::regular);
    int widest = 0;
    for (const std::string& line : lines)
      widest = std::max(widest, text_width_px(line, style.size_px, style.face));
    const int middle = std::max(m_.left_px + width / 2, m_.margin_px + widest / 2 + 1);
    place_lines(lines, middle, bottom - m_.body_px / 4 - m_.column_label.height_px, style, Align::centre);
  }

  void place_row_value(const std::string& value, int slot_top) {
    const int line_px = line_height_px(m_.value_px), room = std::max(1, m_.slot_height_px / line_px);
    const auto lines = block_lines(value, {m_.value_px, m_.row_values_width_px, room, 0}, Face::regular);
    const int height = static_cast<int>(lines.size()) * line_px;
    place_lines(lines, m_.left_px - m_.value_px / 2, slot_top + (m_.slot_height_px - height) / 2,
                value_style(), Align::right);
  }

  void place_row_label(int rows) {
    const TextStyle style{m_.row_label.size_px, Face::regular, kTextColour};
    const int height = rows * m_.row_pitch_px() - m_.row_gap_px();
    int left = m_.margin_px;
    for (const std::string& line : block_lines(layout_.rows.label, m_.row_label, Face::regular)) {
      const int length = text_width_px(line, style.size_px, style.face);
      const int bottom = std::min(m_.top_px + (height + length) / 2, m_.height_px - m_.margin_px);
      sheet_.lines.push_back(
          {line, style, left + baseline_px(style.size_px), std::max(bottom, length), true});
      left += line_height_px(style.size_px);
    }
  }

  void place_slot(int slot_left, int slot_top, int column, int row) {
    sheet_.slots.push_back({slot_left + (m_.slot_width_px - m_.cell_width_px) / 2,
                            slot_top + (m_.slot_height_px - m_.cell_height_px) / 2, column, row});
  }

  int slot_left_px(int column) const { return m_.left_px + column * (m_.slot_width_px + m_.gutter_px); }

  void place_matrix() {
    const int columns = part_.end_column - part_.first_column, rows = part_.end_row - part_.first_row;
    place_column_label(layout_.columns.label, columns, m_.top_px - m_.column_values_height_px);
    for (int column = 0; column < columns; ++column) {
      place_column_value(layout_.columns.values[part_.first_column + column], slot_left_px(column),
                         m_.top_px);
    }
    place_row_label(rows);
    int top = m_.top_px;
    for (int row = 0; row < rows; ++row, top += m_.row_pitch_px()) {
      place_row_value(layout_.rows.values[part_.first_row + row], top);
      for (int column = 0; column < columns; ++column) {
        place_slot(slot_left_px(column), top, part_.first_column + column, part_.first_row + row);
      }
    }
    sheet_.height_px = top - m_.row_gap_px() + m_.margin_px;
  }

  void place_flow() {
    const GridAxis& axis = *flow_axis(layout_);
    const bool along_columns = &axis == &layout_.columns;
    place_column_label(axis.label, std::min(m_.counts.columns, part_.end_column - part_.first_column),
                       m_.top_px);
    int rows = 0;
    for (int i = part_.first_column; i < part_.end_column; ++i) {
      const int place = i - part_.first_column;
      const int left = slot_left_px(place % m_.counts.columns);
      rows = place / m_.counts.columns + 1;
      const int top = m_.top_px + (rows - 1) * m_.row_pitch_px() + m_.column_values_height_px;
      place_column_value(axis.values[i], left, top);
      place_slot(left, top, along_columns ? i : 0, along_columns ? 0 : i);
    }
    sheet_.height_px = m_.top_px + rows * m_.row_pitch_px() - m_.row_gap_px() + m_.margin_px;
  }

  const GridLayout& layout_;
  const GridMetrics& m_;
  const Part& part_;
  GridSheet sheet_;
};

std::vector<Part> parts_of_page(const GridLayout& layout, const GridCounts& counts, int page) {
  const GridAxis* axis = flow_axis(layout);
  const int columns = static_cast<int>(axis != nullptr ? axis->values.size() : layout.columns.values.size());
  const int rows = axis != nullptr ? 1 : static_cast<int>(layout.rows.values.size());
  const int column_step = counts.flow ? counts.columns * counts.rows : counts.columns;
  const int row_step = counts.flow ? 1 : counts.rows;
  std::vector<Part> parts;
  for (int row = 0; row < rows; row += row_step) {
    for (int column = 0; column < columns; column += column_step) {
      parts.push_back(
          {page, column, std::min(columns, column + column_step), row, std::min(rows, row + row_step), ""});
    }
  }
  if (parts.size() == 1) return parts;
  for (size_t i = 0; i < parts.size(); ++i) {
    parts[i].name = "part " + std::to_string(i + 1) + " of " + std::to_string(parts.size());
  }
  return parts;
}

}  // namespace

GridPlan plan_grid(const GridLayout& layout) {
  assert(layout.cell_width_px > 0 && layout.cell_height_px > 0 && layout.max_side_px >= 1024);
  assert(!layout.columns.values.empty() && !layout.rows.values.empty() && !layout.pages.values.empty());
  const GridMetrics metrics = fitted_metrics(layout);
  GridPlan plan{metrics.cell_width_px, metrics.cell_height_px, metrics.frame_px, metrics.body_px, {}};
  for (int page = 0; page < std::ssize(layout.pages.values); ++page) {
    for (const Part& part : parts_of_page(layout, metrics.counts, page)) {
      plan.sheets.push_back(SheetMaker(layout, metrics, part).make());
    }
  }
  return plan;
}

}  // namespace inkbench
