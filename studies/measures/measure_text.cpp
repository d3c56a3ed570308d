// SPDX-License-Identifier: MIT
// The table of measures and their values as text.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pipeline/base/text.h"
#include "studies/measures/measures.h"

namespace inkbench {
namespace {

using Measures = std::span<const Measure* const>;

std::string needs_text(const Measure& measure) {
  switch (measure.needs) {
    case Need::nothing:
      return "the scene";
    case Need::drawn_lines:
      return "drawn lines";
    case Need::reference_lines:
      return "reference lines";
    case Need::polylines:
      return "reference lines as paths";
    case Need::reference_class:
      return "reference lines, " + std::string(name_of(*measure.line_class));
    case Need::full_mesh:
      return "reference lines, of the full mesh too";
    case Need::inner_lines:
      return "reference lines, the full mesh's drawing";
    case Need::frames:
      return "drawn lines along a camera path";
    case Need::reference_frames:
      return "reference lines along a camera path";
    case Need::stroke_frames:
      return "strokes along a camera path";
    case Need::placed_lines:
      return "lines of a method that places them";
    case Need::strengths:
      return "reference lines, the detector's strength at 99 thresholds";
    case Need::causes:
      return "the drawing made again with one thing changed at a time";
    case Need::marks:
      return "a person's marks";
  }
  return "";
}

std::string_view better_text(Better better) {
  constexpr std::array<std::string_view, 3> kTexts{"more", "less", ""};
  return kTexts[static_cast<size_t>(better)];
}

template <class Test>
std::vector<const Measure*> measures_that(const Test& test) {
  std::vector<const Measure*> result;
  for (const Measure& measure : measure_table()) {
    if (test(measure)) result.push_back(&measure);
  }
  return result;
}

std::string value_text(const Measure& measure, const DrawingTally& tally) {
  const std::optional<double> value = measure.value(tally);
  if (!value) return "-";
  return measure.kind == MeasureKind::count ? with_commas(static_cast<long long>(*value))
                                            : fmt::format("{:.4f}", *value);
}

}  // namespace

std::string measure_text(const Measure& measure, const DrawingTally& tally) {
  const std::optional<double> value = measure.value(tally);
  if (!value) return "";
  if (measure.kind == MeasureKind::flag) return *value != 0 ? "true" : "false";
  return measure.kind == MeasureKind::count ? fmt::format("{:.0f}", *value) : shortest(*value);
}

std::string measures_json(Measures measures, const DrawingTally& tally) {
  std::string json;
  for (const Measure* measure : measures) {
    const std::string text = measure_text(*measure, tally);
    json +=
        fmt::format("{}\"{}\": {}", json.empty() ? "{" : ", ", measure->key, text.empty() ? "null" : text);
  }
  return json + "}";
}

std::string measures_table(Measures measures, const DrawingTally& tally) {
  size_t width = 0;
  for (const Measure* measure : measures) width = std::max(width, measure->key.size());
  std::string table;
  for (const Measure* measure : measures) {
    if (measure->kind == MeasureKind::flag) continue;
    table += fmt::format(
        "{:<{}} {:>11}  {}\n", measure->key, width, value_text(*measure, tally),
        measure->unit.empty() ? measure->help : fmt::format("{} ({})", measure->help, measure->unit));
  }
  return table;
}

std::vector<const Measure*> measures_of_maps(bool with_classes) {
  return measures_that([=](const Measure& measure) {
    return measure.needs == Need::drawn_lines || measure.needs == Need::reference_lines ||
           measure.needs == Need::polylines || (with_classes && measure.needs == Need::reference_class);
  });
}

std::vector<const Measure*> all_measures() {
  return measures_that([](const Measure&) { return true; });
}

std::vector<const Measure*> measures_of_a_view(bool with_causes) {
  return measures_that([=](const Measure& measure) {
    return !measure.of_path() && !measure.of_marks() && measure.needs != Need::strengths &&
           (with_causes || measure.needs != Need::causes);
  });
}

std::string measures_markdown() {
  std::string text = "| key | what it says | unit | better | needs |\n|---|---|---|---|---|\n";
  for (const Measure& measure : measure_table()) {
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", measure.key, measure.help, measure.unit,
                        better_text(measure.better), needs_text(measure));
  }
  return text;
}

}  // namespace inkbench
