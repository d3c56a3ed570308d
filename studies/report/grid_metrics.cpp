// SPDX-License-Identifier: MIT
#include "studies/report/grid_metrics.h"

#include <algorithm>
#include <cmath>

namespace inkbench {
namespace {

// The longest single strip of cells; a longer one becomes a block. Names are wider than an axis' values.
constexpr int kLongestNamedStrip = 5;
constexpr int kLongestAxisStrip = 8;

bool stands_alone(const GridAxis& other) {
  return other.values.size() == 1 && other.values.front().empty() && other.label.empty();
}

/// Columns for a block of `count` cells: a little wider than high, with the fewest places left empty.
int block_columns(int count, double cell_aspect) {
  const double square = std::sqrt(count / cell_aspect);
  const int narrowest = std::clamp(static_cast<int>(std::ceil(square - 1e-9)), 1, count);
  const int widest = std::clamp(static_cast<int>(std::ceil(1.5 * square)), narrowest, count);
  const auto empty_places = [&](int columns) { return (count + columns - 1) / columns * columns - count; };
  int best = narrowest;
  for (int columns = narrowest; columns <= widest; ++columns) {
    if (empty_places(columns) < empty_places(best)) best = columns;
  }
  return best;
}

int ceil_div(int a, int b) {
  return (a + b - 1) / b;
}

std::string joined_with_dot(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + " \xc2\xb7 " + b;
}

std::string page_text(const GridAxis& pages, int page) {
  const std::string& value = pages.values[static_cast<size_t>(page)];
  return value.empty() || pages.label.empty() ? value : pages.label + " = " + value;
}

/// `line` with an ellipsis at its end, shortened until both fit.
std::string with_ellipsis(std::string line, int width_px, int size_px, Face face) {
  const std::string ellipsis = "\xe2\x80\xa6";
  while (!line.empty() && text_width_px(line + ellipsis, size_px, face) > width_px) {
    while ((static_cast<uint8_t>(line.back()) & 0xc0) == 0x80 && line.size() > 1) line.pop_back();
    line.pop_back();
  }
  return line + ellipsis;
}

}  // namespace

const GridAxis* flow_axis(const GridLayout& layout) {
  const auto too_long = [](const GridAxis& axis) {
    return std::ssize(axis.values) > (axis.label.empty() ? kLongestNamedStrip : kLongestAxisStrip);
  };
  if (stands_alone(layout.rows) && too_long(layout.columns)) return &layout.columns;
  if (stands_alone(layout.columns) && too_long(layout.rows)) return &layout.rows;
  return nullptr;
}

std::vector<std::string> block_lines(const std::string& text, const TextBlock& block, Face face) {
  if (text.empty()) return {};
  std::vector<std::string> lines = wrapped(text, block.width_px, block.size_px, face);
  if (std::ssize(lines) > block.max_lines) {
    lines.resize(block.max_lines);
    lines.back() = with_ellipsis(lines.back(), block.width_px, block.size_px, face);
  }
  return lines;
}

std::string subtitle_text(const GridLayout& layout, int page, const std::string& part) {
  return joined_with_dot(joined_with_dot(page_text(layout.pages, page), layout.subtitle), part);
}

namespace {

/// Sizes a block for the tallest of `texts`: shrunk a little, then wrapped; at most `max_height_px` high.
TextBlock sized_block(std::span<const std::string> texts, FitLimits limits, int max_height_px, Face face) {
  TextBlock block;
  block.width_px = limits.width_px;
  block.size_px = fitted_size_px(texts, limits, face);
  block.max_lines = std::max(1, max_height_px / line_height_px(block.size_px));
  size_t lines = 0;
  for (const std::string& text : texts) lines = std::max(lines, block_lines(text, block, face).size());
  block.height_px = static_cast<int>(lines) * line_height_px(block.size_px);
  return block;
}

/// Finds the metrics for cells of one size and one number of them on a sheet.
class Measurer {
 public:
  explicit Measurer(const GridLayout& layout)
      : layout_(layout), flow_(flow_axis(layout)), columns_(flow_ != nullptr ? *flow_ : layout.columns) {
    for (int page = 0; page < std::ssize(layout.pages.values); ++page) {
      subtitles_.push_back(subtitle_text(layout, page, ""));
      subtitles_in_parts_.push_back(subtitle_text(layout, page, "part 999 of 999"));
    }
  }

  GridMetrics measure(double scale, const GridCounts& counts, bool in_parts) const {
    GridMetrics m;
    m.counts = counts;
    m.cell_width_px = std::max(1, static_cast<int>(std::lround(layout_.cell_width_px * scale)));
    m.cell_height_px = std::max(1, static_cast<int>(std::lround(layout_.cell_height_px * scale)));
    measure_slots(m);
    measure_type(m);
    measure_values(m);
    measure_axis_labels(m);
    measure_header(m, in_parts);
    m.height_px = m.top_px + m.block_height_px() + m.margin_px;
    return m;
  }

 private:
  /// Slots as large as cells, and wider or higher where the smallest text needs it.
  void measure_slots(GridMetrics& m) const {
    constexpr int kWidestWord =
        8 * kSmallestText;  // Longer words are broken rather than spread tiny cells apart.
    int value_px = 0;
    for (const std::string& value : columns_.values) {
      value_px = std::max(value_px, widest_word_px(value, kSmallestText, Face::regular));
    }
    const auto share = [](const GridAxis& axis, int count) {
      return ceil_div(widest_word_px(axis.label, kSmallestText, Face::regular), std::max(1, count));
    };
    m.slot_width_px = std::max({m.cell_width_px, std::min(kWidestWord, ceil_div(value_px * 25, 24) + 1),
                                std::min(kWidestWord, share(columns_, m.counts.columns))});
    m.slot_height_px = m.cell_height_px;
    if (!m.counts.flow) {
      m.slot_height_px =
          std::max(m.slot_height_px, std::min(kWidestWord, share(layout_.rows, m.counts.rows)));
    }
  }

  /// Text grows with the sheet, since the sheet is shown at the size of a paper's page: a sixtieth of its
  /// width is 8 points in a figure of 17 cm. Bounded from below by what one cell needs and by what a narrow
  /// sheet has room for.
  void measure_type(GridMetrics& m) const {
    m.gutter_px = std::clamp(m.slot_width_px / 40, 4, 48);
    const int width_px = m.block_width_px();
    const int extent_px = std::max(width_px, m.counts.rows * (m.slot_height_px + m.gutter_px) * 7 / 10);
    m.body_px = std::max({kSmallestText, m.slot_width_px / 22, std::min(extent_px / 60, width_px / 12)});
    m.frame_px = std::max(1, m.body_px / 28);
    m.gutter_px += 2 * m.frame_px;
    m.margin_px = std::max(12, m.body_px);
  }

  void measure_values(GridMetrics& m) const {
    const int room_px = layout_.max_side_px / 4;
    FitLimits limits{m.value_width_px(), m.body_px, kSmallestText, 3};
    m.value_px = fitted_size_px(columns_.values, limits, Face::regular);
    if (!m.counts.flow) measure_row_values(m);
    limits.largest_px = m.value_px;
    const TextBlock block = sized_block(columns_.values, limits, room_px, Face::regular);
    m.value_px = block.size_px;
    m.column_values_height_px = block.height_px == 0 ? 0 : block.height_px + m.value_px / 3;
  }

  void measure_row_values(GridMetrics& m) const {
    const std::vector<std::string>& values = layout_.rows.values;
    const int widest_px = std::max(m.slot_width_px / 2, 8 * kSmallestText);
    const int room_px = std::max(layout_.max_side_px / 4, line_height_px(kSmallestText));
    const int lines = std::max(1, m.slot_height_px / line_height_px(m.value_px));
    const FitLimits limits{widest_px, m.value_px, kSmallestText, std::min(lines, 4)};
    const TextBlock block = sized_block(values, limits, room_px, Face::regular);
    m.value_px = block.size_px;
    m.slot_height_px = std::max(m.slot_height_px, block.height_px);
    int width_px = 0;
    for (const std::string& value : values) {
      for (const std::string& line : block_lines(value, block, Face::regular)) {
        width_px = std::max(width_px, text_width_px(line, m.value_px, Face::regular));
      }
    }
    m.row_values_width_px = width_px;
  }

  void measure_axis_labels(GridMetrics& m) const {
    const auto block = [&](const GridAxis& axis, int length_px) {
      const int room_px = layout_.max_side_px / 8;
      return sized_block({&axis.label, 1}, {length_px, m.body_px, kSmallestText, 2}, room_px, Face::regular);
    };
    m.column_label = block(columns_, m.block_width_px());
    m.left_px = m.margin_px;
    if (m.counts.flow) return;
    m.row_label = block(layout_.rows, m.block_height_px());
    if (m.row_label.height_px > 0) m.left_px += m.row_label.height_px + m.body_px / 3;
    if (m.row_values_width_px > 0) m.left_px += m.row_values_width_px + m.value_px / 2;
  }

  void measure_header(GridMetrics& m, bool in_parts) const {
    const std::vector<std::string>& subtitles = in_parts ? subtitles_in_parts_ : subtitles_;
    const int title_px = m.body_px * 4 / 3;
    // Under narrow blocks of cells the sheet goes on, so that the title keeps to a few lines.
    int longest_px = text_width_px(layout_.title, kSmallestText, Face::bold);
    for (const std::string& text : subtitles) {
      longest_px = std::max(longest_px, text_width_px(text, kSmallestText, Face::regular));
    }
    const int least_px = std::min(longest_px + 1, 26 * kSmallestText);
    const int content_px = std::max(m.left_px - m.margin_px + m.block_width_px(), least_px);
    m.width_px = content_px + 2 * m.margin_px;
    const int room_px = layout_.max_side_px / 5;
    m.title = sized_block({&layout_.title, 1}, {content_px, title_px, kSmallestText, 3}, room_px, Face::bold);
    m.subtitle = sized_block(subtitles, {content_px, m.body_px, kSmallestText, 3}, room_px, Face::regular);
    m.top_px = m.margin_px + m.title.height_px + m.subtitle.height_px;
    if (m.title.height_px > 0 && m.subtitle.height_px > 0) m.top_px += m.body_px / 4;
    if (m.title.height_px + m.subtitle.height_px > 0) m.top_px += m.body_px * 4 / 5;
    if (m.column_label.height_px > 0) m.top_px += m.column_label.height_px + m.body_px / 4;
    if (!m.counts.flow) m.top_px += m.column_values_height_px;
  }

  const GridLayout& layout_;
  const GridAxis* flow_;
  const GridAxis& columns_;
  std::vector<std::string> subtitles_, subtitles_in_parts_;
};

/// Chooses the largest cells with which a sheet holds all, else the smallest allowed and as many as a sheet
/// holds.
class Fitter {
 public:
  explicit Fitter(const GridLayout& layout) : layout_(layout), measurer_(layout) {
    const GridAxis* axis = flow_axis(layout);
    flow_ = axis != nullptr;
    columns_ = static_cast<int>(flow_ ? axis->values.size() : layout.columns.values.size());
    rows_ = flow_ ? 1 : static_cast<int>(layout.rows.values.size());
  }

  GridMetrics fit() const {
    const int longer_px = std::max(layout_.cell_width_px, layout_.cell_height_px);
    const int least_px = std::min(layout_.min_cell_px, longer_px);
    GridCounts all = counts(columns_, rows_);
    if (GridMetrics m = measured(longer_px, all); fits(m)) return m;
    if (fits(measured(least_px, all))) return largest(all, least_px, longer_px);
    for (int side_px = least_px; side_px > 1; side_px /= 2) {
      const GridCounts some = most(side_px);
      if (fits(measured(side_px, some))) return measured(side_px, some);
    }
    return measured(1, counts(1, 1));
  }

 private:
  GridCounts counts(int columns, int rows) const {
    if (!flow_) return {false, columns, rows};
    const int in_row =
        block_columns(columns, static_cast<double>(layout_.cell_width_px) / layout_.cell_height_px);
    return {true, in_row, ceil_div(columns, in_row)};
  }

  GridMetrics measured(int longer_px, const GridCounts& some) const {
    const double scale =
        static_cast<double>(longer_px) / std::max(layout_.cell_width_px, layout_.cell_height_px);
    return measurer_.measure(scale, some, some.columns * some.rows < columns_ * rows_);
  }

  bool fits(const GridMetrics& m) const { return std::max(m.width_px, m.height_px) <= layout_.max_side_px; }

  GridMetrics largest(const GridCounts& all, int fitting_px, int too_large_px) const {
    while (too_large_px - fitting_px > 1) {
      const int middle_px = (fitting_px + too_large_px) / 2;
      (fits(measured(middle_px, all)) ? fitting_px : too_large_px) = middle_px;
    }
    return measured(fitting_px, all);
  }

  /// The most cells of one size that a sheet holds, in parts of nearly the same size.
  GridCounts most(int side_px) const {
    int columns = columns_, rows = rows_;
    while (columns > 1 || rows > 1) {
      const GridMetrics m = measured(side_px, counts(columns, rows));
      if (fits(m)) break;
      const auto fewer = [&](int count, int length_px, double power) {
        const double share = std::pow(static_cast<double>(layout_.max_side_px) / length_px, power);
        return share < 1.0 ? std::max(1, std::min(count - 1, static_cast<int>(count * share))) : count;
      };
      if (flow_) {
        columns = fewer(columns, std::max(m.width_px, m.height_px), 2.0);
      } else {
        columns = fewer(columns, m.width_px, 1.0);
        rows = fewer(rows, m.height_px, 1.0);
      }
      if (columns == 1 && rows == 1) break;
    }
    return counts(ceil_div(columns_, ceil_div(columns_, columns)), ceil_div(rows_, ceil_div(rows_, rows)));
  }

  const GridLayout& layout_;
  Measurer measurer_;
  bool flow_ = false;
  int columns_ = 0, rows_ = 0;
};

}  // namespace

GridMetrics fitted_metrics(const GridLayout& layout) {
  return Fitter(layout).fit();
}

}  // namespace inkbench
