// SPDX-License-Identifier: MIT
#include "studies/measures/drawing_tally.h"

namespace inkbench {
namespace {

template <class Tally>
void pool(std::optional<Tally>& sum, const std::optional<Tally>& other) {
  if (sum && other) sum->add(*other);
  if (!sum) sum = other;
}

}  // namespace

void DrawingTally::add(const DrawingTally& other) {
  pixels += other.pixels;
  ink += other.ink;
  if (faces == 0) faces = other.faces;
  lines.add(other.lines);
  for (size_t i = 0; i < recall.size(); ++i) recall[i].add(other.recall[i]);
  pool(ladder, other.ladder);
  pool(inner, other.inner);
  pool(causes, other.causes);
  pool(antialiasing, other.antialiasing);
  pool(strengths, other.strengths);
  pool(flicker, other.flicker);
  pool(strokes, other.strokes);
  pool(marks, other.marks);
}

DrawingTally tally_maps(const LinesToMeasure& lines) {
  DrawingTally tally;
  tally.pixels = int64_t{lines.prediction.width_px()} * lines.prediction.height_px();
  tally.ink = lines.prediction.count();
  tally.lines = tally_lines(lines);
  return tally;
}

}  // namespace inkbench
