// SPDX-License-Identifier: MIT
#include "studies/measures/diff_picture.h"

#include <array>
#include <string>
#include <vector>

#include "pipeline/base/text.h"
#include "studies/measures/match_maps.h"
#include "studies/report/lettering.h"

namespace inkbench {
namespace {

using Colour = std::array<uint8_t, 3>;
constexpr Colour kInk = {224, 224, 224};
constexpr int kTextPx = 13, kSwatchPx = 12, kSpacePx = 6, kMarginPx = 8;

struct LegendItem {
  Colour colour;
  std::string text;

  int width_px() const {
    return kSwatchPx + kSpacePx + text_width_px(text, kTextPx, Face::regular) + 2 * kMarginPx;
  }
};

void paint(Picture& picture, int x, int y, const Colour& colour) {
  for (int c = 0; c < 3; ++c) picture.at(x, y, c) = colour[c];
}

void paint_lines(Picture& picture, const LineMap& lines, const Colour& colour) {
  for_each_pixel(lines, [&](int x, int y) { paint(picture, x, y, colour); });
}

std::vector<LegendItem> legend_of(const MatchMaps& maps, bool with_allowed) {
  std::vector<LegendItem> items{{kMatchedColour, "matched " + with_commas(maps.matched.count())},
                                {kMissedColour, "missed " + with_commas(maps.missed.count())},
                                {kFalseColour, "false " + with_commas(maps.wrong.count())}};
  if (with_allowed) items.push_back({kAllowedColour, "allowed " + with_commas(maps.allowed.count())});
  return items;
}

void draw_legend(Picture& picture, std::span<const LegendItem> items, int top) {
  int x = kMarginPx;
  for (const LegendItem& item : items) {
    const int first_y = top + (kDiffLegendHeightPx - kSwatchPx) / 2;
    for (int dy = 0; dy < kSwatchPx; ++dy) {
      for (int dx = 0; dx < kSwatchPx; ++dx) paint(picture, x + dx, first_y + dy, item.colour);
    }
    const int text_top = top + (kDiffLegendHeightPx - line_height_px(kTextPx)) / 2;
    draw_text(picture, x + kSwatchPx + kSpacePx, text_top + baseline_px(kTextPx), item.text,
              {.size_px = kTextPx});
    x += item.width_px();
  }
}

}  // namespace

Picture diff_picture(const LineMap& prediction, const LineMap& reference, double tolerance_px,
                     const LineMap* allowed) {
  const int width = prediction.width_px(), height = prediction.height_px();
  const MatchMaps maps = match_maps(
      {prediction, reference, allowed != nullptr ? *allowed : LineMap(width, height), {}}, tolerance_px);
  const std::vector<LegendItem> items = legend_of(maps, allowed != nullptr);
  int legend_width = kMarginPx;
  for (const LegendItem& item : items) legend_width += item.width_px();
  const bool with_legend = legend_width <= width;
  Picture picture(width, height + (with_legend ? kDiffLegendHeightPx : 0), 3, 255);
  paint_lines(picture, without_border(prediction), kInk);
  paint_lines(picture, maps.allowed, kAllowedColour);
  paint_lines(picture, maps.matched, kMatchedColour);
  paint_lines(picture, maps.missed, kMissedColour);
  paint_lines(picture, maps.wrong, kFalseColour);
  if (with_legend) draw_legend(picture, items, height);
  return picture;
}

}  // namespace inkbench
