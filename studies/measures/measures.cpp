// SPDX-License-Identifier: MIT
#include "studies/measures/measures.h"

#include <algorithm>
#include <utility>

#include "studies/measures/measure_values.h"

namespace inkbench {
namespace {

using Tally = DrawingTally;
using Value = MeasureValue;

constexpr auto kMore = Better::more;
constexpr auto kLess = Better::less;
constexpr auto kCount = MeasureKind::count;

template <size_t index>
Value class_recall(const Tally& tally) {
  return tally.recall[index].share();
}

template <size_t... index>
void add_recalls(std::vector<Measure>& table, std::index_sequence<index...>) {
  const auto row = [&](size_t i, Value (*value)(const Tally&)) {
    const std::string name(kLineClassNames[i]);
    table.push_back({.key = "recall_" + name,
                     .help = "Of the " + name + " lines alone, this share is drawn.",
                     .label = "recall " + name,
                     .better = kMore,
                     .needs = Need::reference_class,
                     .value = value,
                     .line_class = kLineClasses[i]});
  };
  (row(index, class_recall<index>), ...);
}

/// What is drawn, held against the lines that should be there.
std::vector<Measure> agreement_rows() {
  return {
      {.key = "empty",
       .help = "Nothing is drawn and nothing should be.",
       .label = "empty",
       .kind = MeasureKind::flag,
       .value = [](const Tally& t) -> Value { return t.lines.empty() ? 1 : 0; }},
      {.key = "matched",
       .help = "Pixels of drawn lines that pair with one of the wanted lines, one to one.",
       .label = "matched pixels",
       .better = kMore,
       .kind = kCount,
       .value = [](const Tally& t) -> Value { return t.lines.at_tolerance.matched; }},
      {.key = "predicted",
       .help = "Pixels of the drawn lines, thinned to one pixel.",
       .label = "predicted pixels",
       .kind = kCount,
       .needs = Need::drawn_lines,
       .value = [](const Tally& t) -> Value { return t.lines.predicted; }},
      {.key = "referenced",
       .help = "Pixels of the lines that should be there, thinned to one pixel.",
       .label = "referenced pixels",
       .kind = kCount,
       .value = [](const Tally& t) -> Value { return t.lines.referenced; }},
      {.key = "precision",
       .help = "Of what is drawn, this share belongs.",
       .label = "precision",
       .better = kMore,
       .value = precision_of,
       .is_headline = true},
      {.key = "recall",
       .help = "Of what belongs, this share is drawn.",
       .label = "recall",
       .better = kMore,
       .value = recall_of,
       .is_headline = true},
      {.key = "f1",
       .help = "Precision and recall in one number: 1 draws all that belongs and nothing else.",
       .label = "f1",
       .better = kMore,
       .value = [](const Tally& t) { return f1_with(t, t.lines.at_tolerance); },
       .is_headline = true},
      {.key = "f1_t1",
       .help = "f1 where a line may be off by 1 px only.",
       .label = "f1 at 1 px",
       .better = kMore,
       .value = [](const Tally& t) { return f1_with(t, t.lines.at_1px); }},
      {.key = "f1_diag",
       .help = "f1 where a line may be off by 0.75 % of the image's diagonal, as in contour benchmarks.",
       .label = "f1 at 0.75 % of the diagonal",
       .better = kMore,
       .value = [](const Tally& t) { return f1_with(t, t.lines.at_diagonal); }},
  };
}

/// How far off lines are, and what they look like.
std::vector<Measure> shape_rows() {
  return {
      {.key = "chamfer",
       .help = "How far drawn and wanted lines lie apart on average, each pixel at most 10 px.",
       .label = "chamfer distance",
       .unit = "px",
       .better = kLess,
       .value = chamfer_of},
      {.key = "hd95",
       .help = "All but the worst 5 % of drawn and wanted lines lie nearer together than this.",
       .label = "95 % Hausdorff distance",
       .unit = "px",
       .better = kLess,
       .value = hd95_of},
      {.key = "baddeley",
       .help = "How much the surroundings of drawn and wanted lines differ, over the whole image.",
       .label = "Baddeley distance",
       .unit = "px",
       .better = kLess,
       .value = baddeley_of},
      {.key = "breaks_per_100px",
       .help = "Stretches without a line, for each 100 px of wanted line.",
       .label = "breaks per 100 px",
       .better = kLess,
       .value = breaks_of},
      {.key = "mean_gap_px",
       .help = "How long a stretch without a line is on average.",
       .label = "mean gap",
       .unit = "px",
       .better = kLess,
       .value = mean_gap_of},
      {.key = "components",
       .help = "Connected pieces that the drawn lines fall into.",
       .label = "components",
       .kind = kCount,
       .needs = Need::drawn_lines,
       .value = [](const Tally& t) -> Value { return t.lines.components; }},
      {.key = "ends_per_100px",
       .help = "Loose ends, for each 100 px of drawn line.",
       .label = "ends per 100 px",
       .better = kLess,
       .needs = Need::drawn_lines,
       .value = ends_of},
      {.key = "thickness_px",
       .help = "How thick the drawn lines are: half of their pixels are thinner.",
       .label = "thickness",
       .unit = "px",
       .needs = Need::drawn_lines,
       .value = thickness_of},
      {.key = "thickness_cov",
       .help = "How uneven the thickness is: its standard deviation over its mean.",
       .label = "thickness, deviation / mean",
       .better = kLess,
       .needs = Need::drawn_lines,
       .value = thickness_variation_of},
      {.key = "jaggedness_px",
       .help = "How much the ink wobbles along the wanted lines.",
       .label = "jaggedness",
       .unit = "px",
       .better = kLess,
       .needs = Need::polylines,
       .value = jaggedness_of},
      {.key = "bias_px",
       .help = "How far the ink lies to one side of the wanted lines.",
       .label = "bias",
       .unit = "px",
       .needs = Need::polylines,
       .value = bias_of},
      {.key = "ink",
       .help = "Of the whole image, this share is ink.",
       .label = "ink",
       .unit = "share of pixels",
       .needs = Need::drawn_lines,
       .value = ink_share_of,
       .in_every_study = true},
      {.key = "ink_px",
       .help = "Pixels of the whole image that are ink.",
       .label = "ink",
       .unit = "px",
       .kind = kCount,
       .needs = Need::drawn_lines,
       .value = [](const Tally& t) -> Value { return t.ink; },
       .in_every_study = true},
  };
}

/// A level of a mesh against the full mesh.
std::vector<Measure> ladder_rows() {
  return {
      {.key = "f1_geometry",
       .help = "f1 of this mesh's own wanted lines against the full mesh's: what the missing triangles cost.",
       .label = "f1 geometry",
       .better = kMore,
       .needs = Need::full_mesh,
       .value = [](const Tally& t) { return t.ladder ? Value(f1_of(t.ladder->geometry)) : std::nullopt; }},
      {.key = "f1_end_to_end",
       .help =
           "f1 of the lines drawn here against the full mesh's wanted lines: what triangles and filter cost.",
       .label = "f1 end to end",
       .better = kMore,
       .needs = Need::full_mesh,
       .value = [](const Tally& t) { return t.ladder ? Value(f1_of(t.ladder->end_to_end)) : std::nullopt; }},
      {.key = "internal_kept",
       .help = "Of the inner lines drawn with the full mesh, this share is drawn here too.",
       .label = "internal kept",
       .better = kMore,
       .needs = Need::inner_lines,
       .value = [](const Tally& t) { return t.inner ? t.inner->kept.share() : std::nullopt; }},
      {.key = "internal_new",
       .help = "Of the inner lines drawn here, this share is not drawn with the full mesh.",
       .label = "internal new",
       .better = kLess,
       .needs = Need::inner_lines,
       .value = [](const Tally& t) { return t.inner ? t.inner->new_share() : std::nullopt; }},
  };
}

/// What comes and goes while the camera moves.
std::vector<Measure> path_rows() {
  return {
      {.key = "flicker",
       .help = "Of the drawn lines whose place is seen from one frame to the next, this share comes or goes.",
       .label = "flicker",
       .better = kLess,
       .needs = Need::frames,
       .value = [](const Tally& t) { return t.flicker ? t.flicker->drawn.share() : std::nullopt; }},
      {.key = "flicker_reference",
       .help = "The same of the wanted lines: what has to change, since silhouettes slide.",
       .label = "flicker of the reference",
       .better = Better::neither,
       .needs = Need::reference_frames,
       .value = [](const Tally& t) { return t.flicker ? t.flicker->wanted.share() : std::nullopt; }},
      {.key = "stroke_shift_px",
       .help = "How far paint moves along its stroke from one frame to the next: half of it moves less.",
       .label = "shift of the paint",
       .unit = "px",
       .better = kLess,
       .needs = Need::stroke_frames,
       .value = [](const Tally& t) { return t.strokes ? t.strokes->median_shift_px() : std::nullopt; }},
      {.key = "strokes_broken",
       .help = "Of the strokes of one frame, this share goes on in none of the next, or in several.",
       .label = "strokes that break",
       .better = kLess,
       .needs = Need::stroke_frames,
       .value = [](const Tally& t) { return t.strokes ? t.strokes->broken_share() : std::nullopt; }},
  };
}

/// Of lines that a method places.
std::vector<Measure> placed_rows() {
  return {
      {.key = "antialiasing_error",
       .help = "How far each pixel's ink near a line is, at the root of the mean square, from what the same "
               "lines cover.",
       .label = "antialiasing error",
       .better = kLess,
       .needs = Need::placed_lines,
       .value = [](const Tally& t) { return t.antialiasing ? t.antialiasing->drawn_rms() : std::nullopt; }},
      {.key = "aliased_error",
       .help = "The same without antialiasing: what it saves.",
       .label = "error without antialiasing",
       .needs = Need::placed_lines,
       .value = [](const Tally& t) { return t.antialiasing ? t.antialiasing->aliased_rms() : std::nullopt; }},
  };
}

/// Of the detector's strength, over thresholds.
std::vector<Measure> curve_rows() {
  return {
      {.key = "ods",
       .help = "f1 of the detector's own strength, cut at the one threshold that is best for all views.",
       .label = "ODS",
       .better = kMore,
       .needs = Need::strengths,
       .value = [](const Tally& t) -> Value {
         return t.strengths ? Value(t.strengths->ods()) : std::nullopt;
       }},
      {.key = "ois",
       .help = "The same with each view cut at its own best threshold.",
       .label = "OIS",
       .better = kMore,
       .needs = Need::strengths,
       .value = [](const Tally& t) -> Value {
         return t.strengths ? Value(t.strengths->ois()) : std::nullopt;
       }},
      {.key = "ap",
       .help = "Mean precision over all recalls that some threshold of the detector's strength reaches, 0 "
               "elsewhere.",
       .label = "AP",
       .better = kMore,
       .needs = Need::strengths,
       .value = [](const Tally& t) { return t.strengths ? t.strengths->ap() : std::nullopt; }},
  };
}

/// What a person asked for with marks.
std::vector<Measure> mark_rows() {
  return {
      {.key = "marks",
       .help = "How far the drawing complies with a person's marks: both shares below in one number.",
       .label = "marks",
       .better = kMore,
       .needs = Need::marks,
       .value = [](const Tally& t) { return t.marks ? t.marks->value() : std::nullopt; }},
      {.key = "marks_wanted",
       .help = "Of what was marked as wanted, this share has a line.",
       .label = "wanted marks drawn",
       .better = kMore,
       .needs = Need::marks,
       .value = [](const Tally& t) { return t.marks ? t.marks->wanted.share() : std::nullopt; }},
      {.key = "marks_unwanted",
       .help = "Of the lines that were marked as unwanted, this share is gone.",
       .label = "unwanted lines gone",
       .better = kMore,
       .needs = Need::marks,
       .value = [](const Tally& t) { return t.marks ? t.marks->unwanted.share() : std::nullopt; }},
  };
}

template <size_t index>
Value cause_count(const Tally& tally) {
  if (!tally.causes) return std::nullopt;
  return static_cast<double>(tally.causes->pixels[index]);
}

template <size_t... index>
void add_causes(std::vector<Measure>& table, std::index_sequence<index...>) {
  const auto row = [&](const CauseInfo& info, Value (*value)(const Tally&)) {
    const char* what = info.is_of_missed() ? "Missed pixels: " : "False pixels: ";
    table.push_back({.key = std::string(info.key),
                     .help = what + std::string(info.help),
                     .label = (info.is_of_missed() ? "missed, " : "false, ") + std::string(info.name),
                     .better = kLess,
                     .kind = kCount,
                     .needs = Need::causes,
                     .value = value});
  };
  (row(cause_table()[index], cause_count<index>), ...);
}

std::vector<Measure> make_table() {
  std::vector<Measure> table{{.key = "faces",
                              .help = "Triangles of the main model as it is drawn.",
                              .label = "triangles drawn",
                              .kind = kCount,
                              .needs = Need::nothing,
                              .value = [](const Tally& t) -> Value { return t.faces; },
                              .scale = Scale::log}};
  const auto add = [&](std::vector<Measure> rows) {
    std::move(rows.begin(), rows.end(), std::back_inserter(table));
  };
  add(agreement_rows());
  add(shape_rows());
  add_recalls(table, std::make_index_sequence<kLineClasses.size()>());
  add(ladder_rows());
  add(path_rows());
  add(placed_rows());
  add(curve_rows());
  add(mark_rows());
  add_causes(table, std::make_index_sequence<kCauses>());
  return table;
}

}  // namespace

const std::vector<Measure>& measure_table() {
  static const std::vector<Measure> kTable = make_table();
  return kTable;
}

const Measure* find_measure(std::string_view key) {
  const std::vector<Measure>& table = measure_table();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Measure& row) { return row.key == key; });
  return found == table.end() ? nullptr : &*found;
}

std::string_view renamed_measure(std::string_view old_key) {
  return old_key == "f1_detector" ? "f1" : "";
}

void MeasureNeeds::add(const Measure& measure) {
  switch (measure.needs) {
    case Need::nothing:
      faces = true;
      break;
    case Need::drawn_lines:
      drawn = drawn || !measure.in_every_study;  // ink is counted anyway
      break;
    case Need::reference_lines:
    case Need::polylines:
      lines = true;
      break;
    case Need::reference_class:
      classes[static_cast<size_t>(*measure.line_class)] = true;
      break;
    case Need::full_mesh:
      ladder = true;
      break;
    case Need::inner_lines:
      inner = true;
      break;
    case Need::frames:
      frames = true;
      break;
    case Need::stroke_frames:
      stroke_frames = true;
      break;
    case Need::reference_frames:
      reference_frames = true;
      break;
    case Need::placed_lines:
      antialiasing = true;
      break;
    case Need::strengths:
      strengths = true;
      break;
    case Need::causes:
      causes = true;
      break;
    case Need::marks:
      marks = true;
      break;
  }
}

MeasureNeeds MeasureNeeds::of(std::span<const Measure* const> measures) {
  MeasureNeeds needs;
  for (const Measure* measure : measures) needs.add(*measure);
  return needs;
}

MeasureNeeds MeasureNeeds::all() {
  MeasureNeeds needs;
  for (const Measure& measure : measure_table()) needs.add(measure);
  return needs;
}

bool MeasureNeeds::reference_lines() const {
  return lines || strengths || full_mesh() || reference_frames ||
         std::find(classes.begin(), classes.end(), true) != classes.end();
}

}  // namespace inkbench
