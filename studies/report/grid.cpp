// SPDX-License-Identifier: MIT
#include "studies/report/grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "pipeline/base/stop.h"
#include "studies/report/grid_plan.h"
#include "studies/report/scaling.h"

namespace inkbench {
namespace {

constexpr uint8_t kFrameGrey = 190;
constexpr uint8_t kHatchGrey = 224;
constexpr uint8_t kFailedGrey = 246;
constexpr std::array<uint8_t, 3> kFailedTextColour = {120, 120, 120};

/// Copies `source` onto `target`, its upper left pixel to (x, y); all of it must lie inside.
void paste(Picture& target, const Picture& source, int x, int y) {
  for (int row = 0; row < source.height_px; ++row) {
    const auto from = source.samples.begin() + static_cast<ptrdiff_t>(source.index(0, row));
    std::copy_n(from, static_cast<ptrdiff_t>(source.width_px) * 3,
                target.samples.begin() + static_cast<ptrdiff_t>(target.index(x, y + row)));
  }
}

void fill(Picture& picture, int x, int y, int width, int height, uint8_t grey) {
  const int left = std::max(0, x), right = std::min(picture.width_px, x + width);
  if (left >= right) return;
  for (int row = std::max(0, y); row < std::min(picture.height_px, y + height); ++row)
    std::fill_n(&picture.at(left, row), static_cast<size_t>(right - left) * 3, grey);
}

/// What stands in for a failed cell: pale diagonal hatching, and "failed" where the cell is large enough to
/// read it.
Picture failed_picture(const GridPlan& plan) {
  Picture picture(plan.cell_width_px, plan.cell_height_px, 3, kFailedGrey);
  const int period = std::max(6, plan.text_px * 2 / 3);
  for (int y = 0; y < picture.height_px; ++y) {
    for (int x = 0; x < picture.width_px; ++x) {
      if ((x + y) % period < std::max(1, period / 6)) fill(picture, x, y, 1, 1, kHatchGrey);
    }
  }
  const std::string word = "failed";
  const TextStyle style{
      fitted_size_px({&word, 1}, {picture.width_px * 3 / 4, plan.text_px, 10, 1}, Face::regular),
      Face::regular, kFailedTextColour};
  const int width = text_width_px(word, style.size_px, style.face), height = line_height_px(style.size_px);
  if (width >= picture.width_px || height >= picture.height_px) return picture;
  const int left = (picture.width_px - width) / 2, top = (picture.height_px - height) / 2;
  fill(picture, left - style.size_px / 2, top, width + style.size_px, height, kFailedGrey);
  draw_text(picture, left, top + baseline_px(style.size_px), word, style);
  return picture;
}

/// Draws one sheet in strips that each hold one row of cells and what stands above it.
class SheetPainter {
 public:
  SheetPainter(const GridPlan& plan, const GridSheet& sheet, const CellSource& cell, PngStripWriter& writer)
      : plan_(plan), sheet_(sheet), cell_(cell), writer_(writer) {}

  void paint() {
    for (size_t first = 0; first < sheet_.slots.size();) {
      size_t end = first;
      while (end < sheet_.slots.size() && sheet_.slots[end].y_px == sheet_.slots[first].y_px) ++end;
      write_text_down_to(sheet_.slots[first].y_px - plan_.frame_px);
      begin_strip(sheet_.slots[first].y_px + plan_.cell_height_px + plan_.frame_px);
      for (; first < end; ++first) paint_cell(sheet_.slots[first]);
      write_strip();
    }
    write_text_down_to(sheet_.height_px);
  }

 private:
  /// The rows without cells, a few at a time: a large sheet's head is higher than its cells.
  void write_text_down_to(int end) {
    constexpr int kRows = 128;
    while (end_ < end) {
      begin_strip(std::min(end, end_ + kRows));
      write_strip();
    }
  }

  /// On the thread that paints: packed on others, ISA-L gave the same pixels with other bytes now and then.
  void write_strip() { writer_.write(std::exchange(strip_, {})); }

  /// The strip from the last one's end to `end`, white, with all text that reaches into it.
  void begin_strip(int end) {
    top_ = std::exchange(end_, end);
    strip_ = Picture(sheet_.width_px, end - top_, 3, 255);
    for (const GridLine& line : sheet_.lines) {
      const int reach = line.upwards ? text_width_px(line.text, line.style.size_px, line.style.face) : 0;
      const int margin = 2 * line.style.size_px;
      if (line.y_px - reach - margin < end && line.y_px + margin > top_) {
        draw_text(strip_, line.x_px, line.y_px - top_, line.text, line.style, line.upwards);
      }
    }
  }

  void paint_cell(const GridSlot& slot) {
    const int x = slot.x_px, y = slot.y_px - top_, frame = plan_.frame_px;
    fill(strip_, x - frame, y - frame, plan_.cell_width_px + 2 * frame, plan_.cell_height_px + 2 * frame,
         kFrameGrey);
    stop_if_asked();
    const std::optional<Picture> picture = cell_(slot.column, slot.row, sheet_.page);
    if (!picture) {
      paste(strip_, failed(), x, y);
      return;
    }
    assert(picture->channels == 3 && picture->width_px > 0 && picture->height_px > 0);
    const DrawnSize size =
        size_in_cell(picture->width_px, picture->height_px, plan_.cell_width_px, plan_.cell_height_px);
    fill(strip_, x, y, plan_.cell_width_px, plan_.cell_height_px, 255);
    const int left = x + (plan_.cell_width_px - size.width_px) / 2;
    const int top = y + (plan_.cell_height_px - size.height_px) / 2;
    const bool as_is = size.width_px == picture->width_px && size.height_px == picture->height_px;
    paste(strip_, as_is ? *picture : scaled(*picture, size.width_px, size.height_px), left, top);
  }

  const Picture& failed() {
    if (!failed_) failed_ = failed_picture(plan_);
    return *failed_;
  }

  const GridPlan& plan_;
  const GridSheet& sheet_;
  const CellSource& cell_;
  PngStripWriter& writer_;
  std::optional<Picture> failed_;
  Picture strip_;
  int top_ = 0, end_ = 0;  ///< The strip's rows.
};

}  // namespace

DrawnSize size_in_cell(int width_px, int height_px, int cell_width_px, int cell_height_px) {
  const double scale = std::min(static_cast<double>(cell_width_px) / width_px,
                                static_cast<double>(cell_height_px) / height_px);
  const auto side = [&](int length, int limit) {
    return std::clamp(static_cast<int>(std::lround(length * scale)), 1, limit);
  };
  return {side(width_px, cell_width_px), side(height_px, cell_height_px)};
}

std::vector<std::filesystem::path> write_grid(const std::filesystem::path& folder, const GridLayout& layout,
                                              const CellSource& cell, const ImageText& text) {
  const GridPlan plan = plan_grid(layout);
  std::vector<std::filesystem::path> paths;
  for (const GridSheet& sheet : plan.sheets) {
    const std::string number = paths.empty() ? "" : "_" + std::to_string(paths.size() + 1);
    const std::filesystem::path path = folder / ("grid" + number + ".png");
    PngStripWriter writer(path, sheet.width_px, sheet.height_px, 3, text);
    SheetPainter(plan, sheet, cell, writer).paint();
    writer.finish();
    paths.push_back(path);
  }
  return paths;
}

}  // namespace inkbench
