// SPDX-License-Identifier: MIT
#include "app/workbench/live_judge.h"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <optional>
#include <utility>

#include "pipeline/base/error.h"
#include "studies/judging/measured_lines.h"

namespace inkbench {
namespace {

void check_view(const JudgedView& view, const Image& like) {
  if (view.edges == nullptr || view.lines == nullptr)
    throw input_error("measures", "edges or reference lines are missing");
  for (const auto& [width, height] : {std::pair{view.edges->width_px, view.edges->height_px},
                                      {view.lines->width_px, view.lines->height_px}}) {
    if (width == like.width_px && height == like.height_px) continue;
    throw input_error("measures",
                      fmt::format("{} x {} against {} x {}", like.width_px, like.height_px, width, height),
                      "edges and reference lines must have one size");
  }
}

void check_request(const JudgeRequest& request) {
  if (request.view.edges == nullptr) throw input_error("measures", "there are no edges");
  check_view(request.view, *request.view.edges);
  if (request.full.edges != nullptr) check_view(request.full, *request.view.edges);
  const float tolerance = request.judge.tolerance;
  const bool good = tolerance >= kToleranceFromPx && tolerance <= kToleranceToPx;
  if (!good)  // NaN too
    throw input_error("measures", fmt::format("a tolerance of {} px", tolerance),
                      fmt::format("give {} to {}", kToleranceFromPx, kToleranceToPx));
}

}  // namespace

Judgement judge(const JudgeRequest& request, const StopAsked& stop) {
  check_request(request);
  const auto start = std::chrono::steady_clock::now();
  Judgement result;
  result.id = request.id;
  const ReferenceLines& lines = *request.view.lines;
  const LineView view = line_view(line_map_from(*request.view.edges), lines, request.judge);
  std::optional<LineView> full;
  if (request.full.edges != nullptr)
    full = line_view(line_map_from(*request.full.edges), *request.full.lines, request.judge);
  result.tally =
      tally_view({view, &lines, full ? &*full : nullptr}, request.judge, MeasureNeeds::all(), stop);
  if (stop && stop()) return result;
  result.maps = match_maps(view, request.judge.tolerance);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

namespace {

Judgement judge_or_say_why(const JudgeRequest& request, const StopAsked& stop) {
  try {
    return judge(request, stop);
  } catch (const std::exception& error) {
    Judgement result;
    result.id = request.id;
    result.error = error.what();
    return result;
  }
}

}  // namespace

bool is_judged(const Measure& measure, const DrawingTally& tally) {
  const bool is_others =
      measure.needs == Need::nothing || measure.needs == Need::strengths || measure.needs == Need::causes;
  return !is_others && !measure.of_path() && !measure.of_marks() && (!measure.of_level() || tally.ladder);
}

LiveJudge::LiveJudge(News& news)
    : BackgroundWork(judge_or_say_why, WhenNewer::finish, WorkPriority::below, news) {}

}  // namespace inkbench
