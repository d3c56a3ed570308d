// SPDX-License-Identifier: MIT
#include "studies/sweep/study_curves.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "studies/measures/curve_text.h"
#include "studies/report/curve_chart.h"

namespace inkbench {
namespace {

constexpr std::string_view kMethod = "edges.method";
constexpr const char* kChartName = "precision_recall";

/// The axis whose values have a curve each; none where variants have, or all cells share one.
std::optional<size_t> curve_axis(const StudySpec& spec) {
  if (spec.axes.empty()) return std::nullopt;
  const auto method =
      std::find_if(spec.axes.begin(), spec.axes.end(), [](const Axis& axis) { return axis.key == kMethod; });
  return method == spec.axes.end() ? 0 : static_cast<size_t>(method - spec.axes.begin());
}

/// Which curve the cell counts towards, by its coordinates.
size_t curve_of(const StudySpec& spec, const Cell& cell) {
  const std::optional<size_t> axis = curve_axis(spec);
  const size_t place = axis.value_or(0);
  return static_cast<size_t>(place == 0 ? cell.column : place == 1 ? cell.row : cell.page);
}

std::vector<std::string> curve_labels(const StudySpec& spec) {
  if (const std::optional<size_t> axis = curve_axis(spec)) return spec.axes[*axis].value_labels;
  std::vector<std::string> labels;
  for (const NamedSet& variant : spec.variants) labels.push_back(variant.name);
  if (labels.empty()) labels.push_back(spec.title);
  return labels;
}

bool has_chart_by_variant(const StudySpec& spec) {
  return curve_axis(spec) && spec.variants.size() > 1;
}

std::string chart_title(const StudySpec& spec, size_t chart) {
  const std::string by = has_chart_by_variant(spec) ? ", " + spec.variants[chart].name : "";
  return "Precision and recall over thresholds" + by;
}

CurveChartPlan empty_plan(const StudySpec& spec, size_t chart) {
  CurveChartPlan plan{.title = chart_title(spec, chart), .labels = curve_labels(spec)};
  plan.name = has_chart_by_variant(spec) ? fmt::format("{}_{}", kChartName, chart + 1) : kChartName;
  plan.cells.resize(plan.labels.size());
  return plan;
}

StrengthCurve pooled_curve(const std::vector<size_t>& cells, const StudyFolder& folder) {
  StrengthCurve sum;
  for (const size_t cell : cells) {
    if (!folder.is_done(cell)) continue;
    const fs::path path = folder.path() / folder.curve_file(cell);
    sum.add(curve_from_csv(read_file(path, kMostTextBytes), path.string()));
  }
  return sum;
}

std::string script_of(const CurveChartPlan& plan, const StudySpec& spec, const StudyFolder& folder) {
  if (plan.labels.size() > kMostStrengthCurves)
    throw input_error("", fmt::format("{} curves", plan.labels.size()),
                      fmt::format("at most {} can be told apart: use fewer values of {}", kMostStrengthCurves,
                                  curve_axis(spec) ? spec.axes[*curve_axis(spec)].key : "the variants"));
  StrengthChart chart{.name = plan.name,
                      .title = plan.title,
                      .of = "a chart of the study \"" + spec.title + "\"",
                      .writer = "The study"};
  for (size_t i = 0; i < plan.labels.size(); ++i)
    chart.curves.push_back(chart_line(plan.labels[i], pooled_curve(plan.cells[i], folder)));
  chart.notes = {
      "The detector's own strength at thresholds 0.01 to 0.99, matched within 0.0075 x diagonal, all views "
      "and models pooled. Dots: best F. Thin lines: equal F."};
  return strength_chart_script(chart);
}

}  // namespace

std::vector<CurveChartPlan> curve_charts(const StudySpec& spec) {
  std::vector<CurveChartPlan> plans;
  const size_t charts = has_chart_by_variant(spec) ? spec.variants.size() : 1;
  for (size_t i = 0; i < charts; ++i) plans.push_back(empty_plan(spec, i));
  for (size_t i = 0; i < cell_count(spec); ++i) {
    const Cell cell = make_cell(spec, i);
    const auto variant = std::find_if(spec.variants.begin(), spec.variants.end(),
                                      [&](const NamedSet& set) { return set.name == cell.variant; });
    const size_t chart =
        has_chart_by_variant(spec) ? static_cast<size_t>(variant - spec.variants.begin()) : 0;
    plans[chart].cells[curve_of(spec, cell)].push_back(i);
  }
  return plans;
}

std::vector<DrawnChart> curve_charts_in(const fs::path& folder, const StudySpec& spec) {
  std::vector<DrawnChart> charts;
  if (!spec.curves) return charts;
  for (size_t i = 0; i < (has_chart_by_variant(spec) ? spec.variants.size() : 1); ++i) {
    const CurveChartPlan plan = empty_plan(spec, i);
    charts.push_back(chart_files(folder / "charts", plan.name, plan.title));
  }
  return charts;
}

std::vector<DrawnChart> draw_study_curves(const StudySpec& spec, const StudyFolder& folder,
                                          std::vector<std::string>& failures) {
  std::vector<DrawnChart> result;
  for (const CurveChartPlan& plan : curve_charts(spec)) {
    const DrawnChart files = chart_files(folder.path() / "charts", plan.name, plan.title);
    try {
      draw_chart(script_of(plan, spec, folder), files);
      result.push_back(files);
    } catch (const Error& error) {
      failures.push_back("chart " + plan.name + ": " + error.what());
    }
  }
  return result;
}

}  // namespace inkbench
