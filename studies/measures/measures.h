// SPDX-License-Identifier: MIT
// The table of measures: one row says all that anyone must know of a measure. The window's judge, data.csv,
// charts, the report, `score`, `measure` and docs/measures.md are loops over it. In: a tally of one view or
// of several pooled. Out: numbers, and what each is called and means. Definitions: docs/measures.md.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/params/description.h"
#include "studies/measures/drawing_tally.h"

namespace inkbench {

/// What must be known beside the scene before a measure has a value. From `reference_lines` on, reference
/// lines are found.
enum class Need {
  nothing,
  drawn_lines,
  reference_lines,
  polylines,
  reference_class,
  full_mesh,
  inner_lines,
  frames,            ///< The drawn lines along a camera path, and how points move.
  reference_frames,  ///< The reference lines along it.
  stroke_frames,     ///< The strokes along it.
  placed_lines,      ///< Lines of a method that places them.
  strengths,         ///< What the detector sees, at 99 thresholds.
  causes,            ///< The drawing made again with one thing changed at a time.
  marks,             ///< What a person marked in the picture.
};

enum class Better { more, less, neither };

enum class MeasureKind { number, count, flag };

struct Measure {
  std::string key;    ///< JSON key and column of data.csv.
  std::string help;   ///< For a person, in plain words.
  std::string label;  ///< On a chart's axis.
  std::string unit;
  Better better = Better::neither;
  MeasureKind kind = MeasureKind::number;
  Need needs = Need::reference_lines;
  std::optional<double> (*value)(const DrawingTally&) = nullptr;  ///< None where it has none.
  std::optional<LineClass> line_class = {};                       ///< Of `reference_class`.
  bool in_every_study = false;                                    ///< A column of data.csv, asked for or not.
  bool is_headline = false;     ///< A share of 0 to 1 that a judge looks at first.
  Scale scale = Scale::linear;  ///< Of a chart's axis.

  /// Whether it compares a level of the mesh with the full one.
  bool of_level() const { return needs == Need::full_mesh || needs == Need::inner_lines; }
  /// Whether it compares the frames of a camera path.
  bool of_path() const {
    return needs == Need::frames || needs == Need::reference_frames || needs == Need::stroke_frames;
  }
  /// Whether it looks at what a person marked, which studies and single views know nothing of.
  bool of_marks() const { return needs == Need::marks; }
};

/// All of them, in the order in which tables show them.
const std::vector<Measure>& measure_table();

/// Null where there is none of that key.
const Measure* find_measure(std::string_view key);

/// The key that a measure has now, by one that it had before; "" for any other.
std::string_view renamed_measure(std::string_view old_key);

/// What is to be found out for some measures.
struct MeasureNeeds {
  bool faces = false;
  bool drawn = false;  ///< The drawn lines by themselves.
  bool lines = false;  ///< And against the reference lines.
  std::array<bool, kLineClasses.size()> classes{};
  bool ladder = false, inner = false;
  bool frames = false, reference_frames = false, stroke_frames = false;
  bool antialiasing = false, strengths = false, causes = false;
  bool marks = false;

  void add(const Measure& measure);
  /// Of all measures.
  static MeasureNeeds all();
  /// Of these.
  static MeasureNeeds of(std::span<const Measure* const> measures);

  bool reference_lines() const;
  bool full_mesh() const { return ladder || inner; }
  bool flicker() const { return frames || reference_frames; }
};

/// The value as shortest text that reads back exactly: counts without a point, flags as true or false; ""
/// where there is none.
std::string measure_text(const Measure& measure, const DrawingTally& tally);

/// One JSON object on one line, a key for each of the measures; null where there is no value.
std::string measures_json(std::span<const Measure* const> measures, const DrawingTally& tally);

/// A table for people: key, value, meaning; without flags.
std::string measures_table(std::span<const Measure* const> measures, const DrawingTally& tally);

/// Those that two line maps are enough for; `with_classes`: where the wanted lines are known by class.
std::vector<const Measure*> measures_of_maps(bool with_classes = false);
std::vector<const Measure*> all_measures();

/// Those that one picture is enough for, without what takes a matching for each of 99 thresholds.
std::vector<const Measure*> measures_of_a_view(bool with_causes = false);

/// What docs/measures.md shows: every measure with its unit, direction, needs and meaning.
std::string measures_markdown();

}  // namespace inkbench
