// SPDX-License-Identifier: MIT
#include "studies/measures/marks.h"

#include <algorithm>

#include "studies/measures/components.h"
#include "studies/measures/disc.h"

namespace inkbench {
namespace {

Disc disc_within(double distance_px) {
  return Disc(static_cast<int64_t>(distance_px * distance_px));
}

bool has_line_near(const LineMap& drawn, const Disc& disc, const Pixel& pixel) {
  return any_word_in_disc(drawn, disc, pixel, [](uint64_t, int, int) { return true; });
}

/// How many pixels of the map have (or have not) a line of the drawing near.
ShareCounts count_near(const LineMap& map, const LineMap& drawn, double within_px, bool should_be) {
  const Disc disc = disc_within(within_px);
  ShareCounts counts;
  for_each_pixel(map, [&](int x, int y) {
    ++counts.total;
    if (has_line_near(drawn, disc, {x, y}) == should_be) ++counts.matched;
  });
  return counts;
}

LineMap both(const LineMap& a, const LineMap& b) {
  LineMap result = a;
  for (size_t i = 0; i < result.words().size(); ++i) result.words()[i] &= b.words()[i];
  return result;
}

Pixel centre_of(const std::vector<Pixel>& pixels) {
  Pixel low = pixels.front(), high = low;
  for (const Pixel& pixel : pixels) {
    low = {std::min(low.x, pixel.x), std::min(low.y, pixel.y)};
    high = {std::max(high.x, pixel.x), std::max(high.y, pixel.y)};
  }
  return {(low.x + high.x) / 2, (low.y + high.y) / 2};
}

/// The counts of `counted`'s pixels that lie in each connected part of `painted`.
void add_strokes(std::vector<MarkedStroke>& strokes, const LineMap& painted, const LineMap& counted,
                 const LineMap& drawn, bool is_wanted) {
  const Disc disc = disc_within(is_wanted ? kWantedWithinPx : kUnwantedWithinPx);
  for (const std::vector<Pixel>& part : components_of(painted)) {
    MarkedStroke stroke{is_wanted, centre_of(part), {}};
    for (const Pixel& pixel : part) {
      if (!counted.at(pixel.x, pixel.y)) continue;
      ++stroke.counts.total;
      if (has_line_near(drawn, disc, pixel) == is_wanted) ++stroke.counts.matched;
    }
    strokes.push_back(stroke);
  }
}

}  // namespace

CountedMarks counted_marks(const MarkMaps& marks) {
  return {counted_lines(marks.wanted), without_border(both(marks.unwanted, marks.drawn))};
}

void MarkTally::add(const MarkTally& other) {
  wanted.add(other.wanted);
  unwanted.add(other.unwanted);
}

std::optional<double> MarkTally::value() const {
  const std::optional<double> found = wanted.share(), gone = unwanted.share();
  if (!found || !gone) return found ? found : gone;
  return *found + *gone > 0 ? 2 * *found * *gone / (*found + *gone) : 0;
}

MarkTally tally_marks(const CountedMarks& marks, const LineMap& drawn) {
  return {count_near(marks.wanted, drawn, kWantedWithinPx, true),
          count_near(marks.unwanted, drawn, kUnwantedWithinPx, false)};
}

std::vector<MarkedStroke> look_at_strokes(const MarkMaps& marks, const LineMap& drawn) {
  const CountedMarks counted = counted_marks(marks);
  std::vector<MarkedStroke> strokes;
  add_strokes(strokes, marks.wanted, counted.wanted, drawn, true);
  add_strokes(strokes, marks.unwanted, counted.unwanted, drawn, false);
  return strokes;
}

}  // namespace inkbench
