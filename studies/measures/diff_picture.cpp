// SPDX-License-Identifier: MIT
#include "studies/measures/diff_picture.h"

#include <array>
#include <string>

#include "pipeline/base/text.h"
#include "studies/measures/matching.h"
#include "studies/measures/tally.h"
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

/// Paints the pixels of `lines` whose partner is (or is not) there.
void paint_lines(Picture& picture, const LineMap& lines, const std::vector<int32_t>& partners,
                 bool with_partner, const Colour& colour) {
  size_t number = 0;
  for_each_pixel(lines, [&](int x, int y) {
    if ((partners[number++] >= 0) == with_partner) paint(picture, x, y, colour);
  });
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

Picture diff_picture(const LineMap& prediction, const LineMap& reference, double tolerance_px) {
  const LineMap found = counted_lines(prediction), wanted = counted_lines(reference);
  const Matching matching = matched(found, wanted, tolerance_px);
  const int64_t false_count = found.count() - matching.pairs, missed_count = wanted.count() - matching.pairs;
  const std::array<LegendItem, 3> items = {{{kMatchedColour, "matched " + with_commas(matching.pairs)},
                                            {kMissedColour, "missed " + with_commas(missed_count)},
                                            {kFalseColour, "false " + with_commas(false_count)}}};
  int legend_width = kMarginPx;
  for (const LegendItem& item : items) legend_width += item.width_px();
  const int width = prediction.width_px(), height = prediction.height_px();
  const bool with_legend = legend_width <= width;
  Picture picture(width, height + (with_legend ? kDiffLegendHeightPx : 0), 3, 255);
  for_each_pixel(without_border(prediction), [&](int x, int y) { paint(picture, x, y, kInk); });
  paint_lines(picture, found, matching.partner_of_a, true, kMatchedColour);
  paint_lines(picture, wanted, matching.partner_of_b, false, kMissedColour);
  paint_lines(picture, found, matching.partner_of_a, false, kFalseColour);
  if (with_legend) draw_legend(picture, items, height);
  return picture;
}

}  // namespace inkbench
