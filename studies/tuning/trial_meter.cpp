// SPDX-License-Identifier: MIT
#include "studies/tuning/trial_meter.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <thread>

#include "pipeline/base/error.h"
#include "pipeline/base/stop.h"
#include "pipeline/lines/drawing.h"
#include "pipeline/passes/lines/reference.h"
#include "studies/judging/measured_lines.h"

namespace inkbench {
namespace {

/// Nothing but matchings at the tolerance is behind these.
constexpr std::array<std::string_view, 3> kOfMatchings{"f1", "precision", "recall"};

bool is_of_matchings(const Measure& measure) {
  return std::find(kOfMatchings.begin(), kOfMatchings.end(), measure.key) != kOfMatchings.end();
}

size_t thread_count() {
  return std::clamp<size_t>(std::thread::hardware_concurrency(), 1, 8);
}

/// Views whose passes are all kept take no more than this.
size_t kept_frames(const TuneSpec& spec) {
  constexpr int64_t kMostBytes = 1LL << 30, kBytesPerPixel = 250;
  const int64_t frame = int64_t{spec.base.image.width} * spec.base.image.height * kBytesPerPixel;
  return std::clamp<size_t>(static_cast<size_t>(kMostBytes / std::max<int64_t>(frame, 1)), 1,
                            spec.pictures.size());
}

}  // namespace

TrialMeter::TrialMeter(Pipeline& pipeline, const TuneSpec& spec, const std::filesystem::path& journal)
    : pipeline_(pipeline),
      spec_(spec),
      measures_(spec.objective.measures()),
      keys_(pipeline, MeasureNeeds::of(measures_)),
      journal_(journal),
      marks_(pipeline, spec),
      truths_(spec.pictures.size()),
      workers_(thread_count(), 2 * thread_count()) {
  for (const Measure* measure : measures_) {
    if (is_of_matchings(*measure))
      needs_f1_ = true;
    else
      needs_.add(*measure);
  }
  const ResultOrigin origin = this_origin();
  origin_ = origin.drawing_sources + " " + origin.measuring_sources + " " + origin.renderer;
  for (const Measure* measure : measures_) origin_ += " " + measure->key;
  pipeline.keep_frames(kept_frames(spec));
}

Key TrialMeter::key_of(size_t picture, const Frame& frame) {
  KeyBuilder builder;
  builder.add(origin_).add(keys_.key(frame));
  if (const PictureMarks::Entry* marks = needs_.marks ? marks_.find(picture) : nullptr)
    builder.add(marks->key);
  return builder.key();
}

std::shared_ptr<const TrialMeter::Truth> TrialMeter::truth(size_t picture, const Frame& frame) {
  const JudgeParams& judge = frame.settings().judge;
  Key key;
  if (needs_reference())
    key = KeyBuilder().add(frame.key(BufferName::reference)).add(judge_text(judge)).key();
  std::shared_ptr<const Truth>& held = truths_[picture];
  if (held && held->key == key) return held;
  auto made = std::make_shared<Truth>();
  made->key = key;
  if (needs_.marks) {
    if (const PictureMarks::Entry* marks = marks_.find(picture)) made->marks = &marks->counted;
  }
  if (needs_reference()) {
    made->lines = frame.value<ReferencePass>();
    made->view = line_view({}, *made->lines, judge);
  }
  if (needs_f1_) made->counted = counted_reference(made->view.wanted, &made->view.allowed);
  held = std::move(made);
  return held;
}

DrawingTally TrialMeter::tally(const LineMap& drawn, const Truth& truth, const JudgeParams& judge) const {
  LineView view = truth.view;
  view.drawn = drawn;
  DrawingTally tally = tally_view({view, truth.lines.get(), nullptr}, judge, needs_);
  if (truth.marks != nullptr) tally.marks = tally_marks(*truth.marks, drawn);
  if (!needs_f1_ || needs_.lines) return tally;
  const F1Counts counts = tally_f1(drawn, truth.counted, judge.tolerance);
  tally.lines.predicted = counts.predicted;
  tally.lines.referenced = counts.referenced;
  tally.lines.at_tolerance = counts.at_tolerance;
  return tally;
}

DrawingTally TrialMeter::tally(size_t picture, const Settings& settings) {
  const Frame frame = pipeline_.at(settings);
  const std::shared_ptr<const Truth> known = truth(picture, frame);
  return tally(line_map_from(frame.raw(BufferName::lines)), *known, settings.judge);
}

/// On this thread the drawing, on another one the measuring.
TrialMeter::Pending TrialMeter::start(size_t picture, const Frame& frame) {
  const Key key = key_of(picture, frame);
  if (const auto found = pending_.find(key); found != pending_.end()) {
    ++known_;
    return found->second;
  }
  auto result = std::make_shared<DrawingTally>();
  if (const DrawingTally* known = journal_.find(key)) {
    ++known_;
    *result = *known;
    return result;
  }
  const std::shared_ptr<const Truth> known_truth = truth(picture, frame);
  auto drawn = std::make_shared<const LineMap>(line_map_from(frame.raw(BufferName::lines)));
  const JudgeParams judge = frame.settings().judge;
  workers_.add([this, drawn, known_truth, judge, result] { *result = tally(*drawn, *known_truth, judge); });
  ++measured_;
  pending_[key] = result;
  return result;
}

void TrialMeter::keep_measured() {
  workers_.wait();
  for (const auto& [key, tally] : pending_) journal_.add(key, *tally);
}

std::vector<GroupTallies> TrialMeter::measure(const std::vector<Values>& candidates,
                                              const std::vector<bool>& wanted) {
  std::vector<std::vector<Pending>> drawings(spec_.pictures.size(), std::vector<Pending>(candidates.size()));
  std::vector<bool> is_drawn(candidates.size(), true);
  pending_.clear();
  for (size_t p = 0; p < spec_.pictures.size(); ++p) {
    if (!wanted[spec_.pictures[p].group]) continue;
    const Settings base = picture_settings(spec_, spec_.pictures[p]);
    for (size_t c = 0; c < candidates.size(); ++c) {
      if (stop_asked()) {
        keep_measured();
        throw Stopped();
      }
      try {
        const Settings settings = with_values(base, spec_.space, candidates[c]);
        check_settings(settings);
        drawings[p][c] = start(p, pipeline_.at(settings));
      } catch (const Error& error) {
        is_drawn[c] = false;
        const std::string problem = spec_.pictures[p].name + ": " + error.what();
        if (std::find(problems_.begin(), problems_.end(), problem) == problems_.end())
          problems_.push_back(problem);
      }
    }
  }
  keep_measured();
  std::vector<GroupTallies> result(candidates.size(), GroupTallies(spec_.groups.size()));
  for (size_t c = 0; c < candidates.size(); ++c) {
    if (!is_drawn[c]) continue;
    for (size_t p = 0; p < spec_.pictures.size(); ++p) {
      std::optional<DrawingTally>& sum = result[c][spec_.pictures[p].group];
      if (!drawings[p][c]) continue;
      if (!sum) sum.emplace();
      sum->add(*drawings[p][c]);
    }
  }
  return result;
}

}  // namespace inkbench
