// SPDX-License-Identifier: MIT
#include "studies/judging/drawing_meter.h"

#include <memory>
#include <optional>

#include "pipeline/passes/ink/coverage.h"
#include "pipeline/passes/ink/drawn_ink.h"
#include "pipeline/passes/lines/reference.h"
#include "pipeline/passes/strokes/strokes.h"
#include "pipeline/strength_file.h"
#include "pipeline/strokes/carry_along.h"
#include "studies/judging/cause_finder.h"
#include "studies/measures/matching.h"

namespace inkbench {
namespace {

constexpr int64_t kKeptBytes = 64 << 20;

/// The value of that key; all others are forgotten first where they take too much room.
template <class Value, class Make>
const Value& kept(std::map<Key, Value>& values, const Key& key, int64_t bytes_each, const Make& make) {
  if (const auto found = values.find(key); found != values.end()) return found->second;
  if (static_cast<int64_t>(values.size() + 1) * bytes_each > kKeptBytes) values.clear();
  return values[key] = make();
}

}  // namespace

size_t drawn_faces(MeshStore& meshes, const Settings& settings) {
  const std::optional<size_t> model = main_model_index(settings);
  if (!model) return 0;
  return meshes.get(settings.models[*model], level_of(settings, *model))->face_count();
}

Image drawn_coverage(const Frame& frame) {
  const Picture picture = frame.picture(BufferName::coverage);
  Image coverage(picture.width_px, picture.height_px, 1);
  for (size_t i = 0; i < coverage.samples.size(); ++i)
    coverage.samples[i] = static_cast<float>(picture.samples[i * picture.channels]) / 255.0F;
  return coverage;
}

namespace {

AntialiasingTally antialiasing_of(const Frame& frame) {
  return tally_antialiasing(drawn_coverage(frame), frame.value<AliasedCoverage>()->read(0, 1),
                            frame.value<SampledCoverage>()->read(0, 1));
}

StrokeTally strokes_between(const Frame& before, const Frame& now) {
  StrokeCarrying carrying = carrying_between(*before.value<StrokesPass>(), *now.value<StrokesPass>());
  return {std::move(carrying.shifts_px), carrying.strokes, carrying.broken};
}

StrengthCurve strengths_of(const Frame& frame, const LineView& view) {
  const StrengthLevels levels = levels_of(bounded_strengths(frame.raw(BufferName::edge_strength)));
  const TieredLines lines{view.wanted, view.allowed};
  StrengthCurve curve;
  curve.add(count_strengths(levels, {&lines, 1}, diagonal_tolerance_px(levels.width_px, levels.height_px)));
  return curve;
}

}  // namespace

/// The full mesh has its own level's normals and the drawing's other settings.
Frame DrawingMeter::with_full_mesh(const Frame& frame) {
  Settings full = frame.settings();
  full.mesh = MeshParams{};
  return pipeline_.at(full);
}

LineView DrawingMeter::full_view(const Frame& full) {
  const Settings& settings = full.settings();
  const int64_t bytes = int64_t{settings.image.width} * settings.image.height / 8;
  const Key lines = KeyBuilder().add(full.key(BufferName::reference)).add(judge_text(settings.judge)).key();
  LineView view = kept(full_lines_, lines, 3 * bytes,
                       [&] { return line_view({}, *full.value<ReferencePass>(), settings.judge); });
  if (!needs_.inner) return view;
  view.drawn = kept(full_drawings_, full.key(BufferName::lines), bytes,
                    [&] { return line_map_from(full.raw(BufferName::lines)); });
  return view;
}

DrawingTally DrawingMeter::tally(const Frame& frame, const Frame* before) {
  const Settings& settings = frame.settings();
  // The full mesh first, so that what is kept in the end is this drawing's, which the next may share.
  std::optional<LineView> full;
  if (needs_.full_mesh()) full = full_view(with_full_mesh(frame));
  const LineMap drawn = line_map_from(frame.raw(BufferName::lines));
  std::shared_ptr<const ReferenceLines> lines;
  if (needs_.reference_lines()) lines = frame.value<ReferencePass>();
  const LineView view = lines ? line_view(drawn, *lines, settings.judge) : LineView{drawn, {}, {}, {}};
  DrawingTally tally = tally_view({view, lines.get(), full ? &*full : nullptr}, settings.judge, needs_);
  if (needs_.faces) tally.faces = drawn_faces(pipeline_.meshes(), settings);
  if (needs_.antialiasing && places_lines(settings) && settings.ink.from == InkFrom::filter)
    tally.antialiasing = antialiasing_of(frame);
  if (needs_.strengths) tally.strengths = strengths_of(frame, view);
  if (needs_.causes) {
    last_causes_ = find_causes(pipeline_, settings);
    tally.causes = count_causes(*last_causes_);
  }
  if (needs_.flicker() && before != nullptr) tally.flicker = flicker_.tally(*before, frame);
  if (needs_.flicker() && before == nullptr) flicker_.start(frame);
  if (needs_.stroke_frames && before != nullptr && draws_strokes(settings))
    tally.strokes = strokes_between(*before, frame);
  return tally;
}

DrawingTally DrawingMeter::tally(std::span<const Settings> views) {
  DrawingTally sum;
  for (const Settings& view : views) sum.add(tally(pipeline_.at(view)));
  return sum;
}

Key DrawingMeter::key(const Frame& frame, const Frame* before) {
  KeyBuilder builder;
  if (needs_.flicker() && before != nullptr) builder.add(flicker_.key(*before, frame));
  if (needs_.stroke_frames && before != nullptr)
    builder.add(before->key_of<StrokesPass>()).add(frame.key_of<StrokesPass>());
  builder.add(frame.key(BufferName::lines));
  if (needs_.reference_lines())
    builder.add(frame.key(BufferName::reference)).add(judge_text(frame.settings().judge));
  if (needs_.antialiasing) builder.add("antialiasing").add(frame.picture_key(BufferName::coverage));
  if (needs_.strengths) builder.add("strengths").add(frame.key(BufferName::edge_strength));
  if (needs_.causes) builder.add(causes_key(frame));
  if (!needs_.full_mesh()) return builder.key();
  const Frame full = with_full_mesh(frame);
  builder.add(full.key(BufferName::reference));
  if (needs_.inner) builder.add(full.key(BufferName::lines));
  return builder.key();
}

}  // namespace inkbench
