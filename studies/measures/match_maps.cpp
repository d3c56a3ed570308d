// SPDX-License-Identifier: MIT
#include "studies/measures/match_maps.h"

#include <array>

#include "studies/measures/diff_picture.h"
#include "studies/measures/matching.h"

namespace inkbench {
namespace {

/// The pixels of `lines` that have (or have not) a partner.
LineMap paired(const LineMap& lines, const std::vector<int32_t>& partners, bool with_partner) {
  LineMap result(lines.width_px(), lines.height_px());
  size_t number = 0;
  for_each_pixel(lines, [&](int x, int y) {
    if ((partners[number++] >= 0) == with_partner) result.set(x, y);
  });
  return result;
}

void paint(Picture& picture, const LineMap& map, const std::array<uint8_t, 3>& colour) {
  for_each_pixel(map, [&](int x, int y) {
    for (int c = 0; c < 3; ++c) picture.at(x, y, c) = colour[c];
    picture.at(x, y, 3) = 255;
  });
}

}  // namespace

MatchMaps match_maps(const LineView& view, double tolerance_px) {
  const LineMap drawn = counted_lines(view.drawn);
  const LineMap wanted = counted_lines(view.wanted);
  const Matching required = matched(drawn, wanted, tolerance_px);
  MatchMaps maps;
  maps.matched = paired(drawn, required.partner_of_a, true);
  maps.missed = paired(wanted, required.partner_of_b, false);
  const LineMap both = united(wanted, counted_lines(view.allowed));
  maps.wrong = paired(drawn, matched_from(required, wanted, drawn, both, tolerance_px).partner_of_a, false);
  maps.allowed = drawn;
  for (const LineMap* other : {&maps.matched, &maps.wrong})
    for_each_pixel(*other, [&](int x, int y) { maps.allowed.set(x, y, false); });
  return maps;
}

Picture match_overlay(const MatchMaps& maps) {
  Picture picture(maps.matched.width_px(), maps.matched.height_px(), 4);
  paint(picture, maps.allowed, kAllowedColour);
  paint(picture, maps.matched, kMatchedColour);
  paint(picture, maps.missed, kMissedColour);
  paint(picture, maps.wrong, kFalseColour);
  return picture;
}

}  // namespace inkbench
