// SPDX-License-Identifier: MIT
#include "studies/judging/measured_lines.h"

#include <algorithm>
#include <iterator>

namespace inkbench {
namespace {

std::vector<Polyline> lines_to_follow(const ReferenceLines& lines, const JudgeParams& judge) {
  std::vector<Polyline> result;
  std::copy_if(lines.polylines.begin(), lines.polylines.end(), std::back_inserter(result),
               [&](const Polyline& line) {
                 return tier(judge, line.line_class) == 1 && line.line_class != LineClass::object;
               });
  return result;
}

LineTally tally_against_lines(const LineView& view, const ReferenceLines& lines, const JudgeParams& judge) {
  const std::vector<Polyline> followed = lines_to_follow(lines, judge);
  return tally_lines({.prediction = view.drawn,
                      .reference = view.wanted,
                      .allowed = &view.allowed,
                      .polylines = followed,
                      .tolerance_px = judge.tolerance});
}

/// As if nothing were wanted: what the measures of the drawn lines by themselves need.
LineTally tally_alone(const LineMap& drawn) {
  const LineMap none(drawn.width_px(), drawn.height_px());
  return tally_lines({.prediction = drawn, .reference = none});
}

}  // namespace

LineView line_view(const LineMap& drawn, const ReferenceLines& lines, const JudgeParams& judge) {
  LineMap outline = class_map(lines, LineClass::silhouette);
  for (const LineClass line_class : {LineClass::boundary, LineClass::object}) {
    outline = united(outline, class_map(lines, line_class));
  }
  return {drawn, tier_map(lines, judge, 1), tier_map(lines, judge, 2), outline};
}

DrawingTally tally_view(const KnownView& known, const JudgeParams& judge, const MeasureNeeds& needs,
                        const StopAsked& stop) {
  const auto stopped = [&] { return stop && stop(); };
  const LineView& view = known.view;
  const double tolerance_px = judge.tolerance;
  DrawingTally tally;
  tally.pixels = int64_t{view.drawn.width_px()} * view.drawn.height_px();
  tally.ink = view.drawn.count();
  if (needs.lines && known.lines != nullptr) {
    tally.lines = tally_against_lines(view, *known.lines, judge);
  } else if (needs.drawn) {
    tally.lines = tally_alone(view.drawn);
  }
  for (size_t i = 0; i < kLineClasses.size() && known.lines != nullptr && !stopped(); ++i) {
    if (!needs.classes[i]) continue;
    tally.recall[i] = tally_recall(view.drawn, class_map(*known.lines, kLineClasses[i]), tolerance_px);
  }
  if (known.full == nullptr || stopped()) return tally;
  if (needs.ladder) tally.ladder = tally_against_full(view, *known.full, tolerance_px);
  if (needs.inner) tally.inner = tally_inner(view, *known.full, tolerance_px);
  return tally;
}

}  // namespace inkbench
