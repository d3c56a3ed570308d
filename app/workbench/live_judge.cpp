#include "app/workbench/live_judge.h"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <utility>

#include "pipeline/base/error.h"
#include "studies/reference/measured_lines.h"

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
  const bool good = request.tolerance_px >= kToleranceFromPx && request.tolerance_px <= kToleranceToPx;
  if (!good)  // NaN too
    throw input_error("measures", fmt::format("a tolerance of {} px", request.tolerance_px),
                      fmt::format("give {} to {}", kToleranceFromPx, kToleranceToPx));
}

LadderJudgement judge_ladder(const LineView& level, const LineView& full, double tolerance_px) {
  const LadderTally tally = tally_against_full(level, full, tolerance_px);
  const InnerTally inner = tally_inner(level, full, tolerance_px);
  return {f1_of(tally.geometry), f1_of(tally.end_to_end), inner.kept.share(), inner.new_share()};
}

}  // namespace

Judgement judge(const JudgeRequest& request, const std::function<bool()>& stop) {
  check_request(request);
  const auto stopped = [&] { return stop && stop(); };
  const auto start = std::chrono::steady_clock::now();
  Judgement result;
  result.id = request.id;
  const ReferenceLines& lines = *request.view.lines;
  const LineView view = line_view(drawn_lines(*request.view.edges), lines);
  result.measures = measure_view(view, lines, request.tolerance_px);
  if (stopped()) return result;
  result.maps = match_maps(view, request.tolerance_px);
  for (size_t i = 0; i < kLineClasses.size() && !stopped(); ++i)
    result.recall[i] =
        tally_recall(view.drawn, class_map(lines, kLineClasses[i]), request.tolerance_px).share();
  if (request.full.edges != nullptr && !stopped()) {
    const LineView full = line_view(drawn_lines(*request.full.edges), *request.full.lines);
    result.ladder = judge_ladder(view, full, request.tolerance_px);
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

LiveJudge::LiveJudge(std::function<void()> on_done)
    : on_done_(std::move(on_done)), thread_([this] { serve(); }) {}

LiveJudge::~LiveJudge() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
    waiting_.reset();
  }
  changed_.notify_all();
  thread_.join();
}

void LiveJudge::submit(JudgeRequest request) {
  {
    const std::lock_guard lock(mutex_);
    waiting_ = std::move(request);
  }
  changed_.notify_all();
}

std::optional<Judgement> LiveJudge::poll() {
  const std::lock_guard lock(mutex_);
  return std::exchange(result_, std::nullopt);
}

bool LiveJudge::is_busy() const {
  const std::lock_guard lock(mutex_);
  return working_ || waiting_.has_value();
}

bool LiveJudge::is_closing() const {
  const std::lock_guard lock(mutex_);
  return closing_;
}

void LiveJudge::serve() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return waiting_.has_value() || closing_; });
    if (closing_) return;
    const JudgeRequest request = *std::exchange(waiting_, std::nullopt);
    working_ = true;
    lock.unlock();
    Judgement result;
    try {
      result = judge(request, [this] { return is_closing(); });
    } catch (const std::exception& error) {
      result.id = request.id;
      result.error = error.what();
    }
    lock.lock();
    working_ = false;
    if (closing_) return;
    result_ = std::move(result);
    lock.unlock();
    if (on_done_) on_done_();
    lock.lock();
  }
}

}  // namespace inkbench
