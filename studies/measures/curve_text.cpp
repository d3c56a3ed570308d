// SPDX-License-Identifier: MIT
#include "studies/measures/curve_text.h"

#include <fmt/format.h>

#include <charconv>
#include <vector>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "studies/report/csv.h"

namespace inkbench {
namespace {

const std::vector<std::string> kColumns{"threshold", "precision", "recall",     "f1",
                                        "predicted", "right",     "referenced", "found"};
constexpr const char* kOwnBest = "own";  ///< In place of a threshold.

std::string counts_line(const std::string& threshold, const StrengthCounts& counts) {
  return csv_line(std::vector<std::string>{threshold, shortest(precision_of(counts)),
                                           shortest(recall_of(counts)), shortest(f_of(counts)),
                                           std::to_string(counts.predicted), std::to_string(counts.right),
                                           std::to_string(counts.referenced), std::to_string(counts.found)});
}

std::string threshold_text(int number) {
  return fmt::format("{:.2f}", threshold_of(number));
}

[[noreturn]] void throw_no_curve(const std::string& where) {
  throw work_error(where, "is no table of a curve", "run the study again");
}

int64_t count_in(const std::string& field, const std::string& where) {
  int64_t value = -1;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || value < 0) throw_no_curve(where);
  return value;
}

StrengthCounts counts_in(const std::vector<std::string>& row, const std::string& where) {
  return {count_in(row[4], where), count_in(row[5], where), count_in(row[6], where), count_in(row[7], where)};
}

CurvePoint point_of(const StrengthCounts& counts) {
  return {recall_of(counts), precision_of(counts)};
}

}  // namespace

std::string curve_csv(const CurveCounts& curve) {
  std::string text = csv_line(kColumns);
  for (int i = 0; i < kThresholds; ++i) text += counts_line(threshold_text(i), curve[i]);
  return text;
}

std::string whole_curve_csv(const StrengthCurve& curve) {
  return curve_csv(curve.pooled()) + counts_line(kOwnBest, curve.at_own_best());
}

StrengthCurve curve_from_csv(std::string_view text, const std::string& where) {
  const CsvTable table = parse_csv(text);
  if (table.columns != kColumns || table.rows.size() != kThresholds + 1) throw_no_curve(where);
  CurveCounts pooled;
  for (int i = 0; i < kThresholds; ++i) pooled[i] = counts_in(table.rows[i], where);
  return {pooled, counts_in(table.rows.back(), where)};
}

StrengthCurveLine chart_line(const std::string& label, const StrengthCurve& curve) {
  StrengthCurveLine line{.label = label, .best = point_of(curve.pooled()[curve.best()])};
  line.detail = fmt::format("ODS {:.3f}  OIS {:.3f}", curve.ods(), curve.ois());
  if (curve.ap()) line.detail += fmt::format("  AP {:.3f}", *curve.ap());
  for (const StrengthCounts& counts : curve.pooled()) {
    if (counts.predicted > 0) line.points.push_back(point_of(counts));
  }
  return line;
}

}  // namespace inkbench
