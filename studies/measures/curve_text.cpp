// SPDX-License-Identifier: MIT
#include "studies/measures/curve_text.h"

#include <fmt/format.h>

#include <charconv>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "studies/report/csv.h"

namespace inkbench {
namespace {

const std::vector<std::string> kCountColumns{"picture", "threshold",  "predicted",
                                             "right",   "referenced", "found"};

std::vector<std::string> count_fields(const StrengthCounts& counts) {
  return {std::to_string(counts.predicted), std::to_string(counts.right), std::to_string(counts.referenced),
          std::to_string(counts.found)};
}

std::string threshold_text(int number) {
  return fmt::format("{:.2f}", threshold_of(number));
}

int64_t count_in(const std::string& field, const std::string& where) {
  int64_t value = -1;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || value < 0)
    throw work_error(where, "is no table of counts", "run the study again");
  return value;
}

CurvePoint point_of(const StrengthCounts& counts) {
  return {recall_of(counts), precision_of(counts)};
}

}  // namespace

std::string curve_csv(const CurveCounts& curve) {
  std::string text = csv_line(std::vector<std::string>{"threshold", "precision", "recall", "f1", "predicted",
                                                       "right", "referenced", "found"});
  for (int i = 0; i < kThresholds; ++i) {
    const StrengthCounts& counts = curve[i];
    std::vector<std::string> fields{threshold_text(i), shortest(precision_of(counts)),
                                    shortest(recall_of(counts)), shortest(f_of(counts))};
    for (std::string& field : count_fields(counts)) fields.push_back(std::move(field));
    text += csv_line(fields);
  }
  return text;
}

std::string counts_csv(const std::vector<CurveCounts>& pictures) {
  std::string text = csv_line(kCountColumns);
  for (size_t picture = 0; picture < pictures.size(); ++picture) {
    for (int i = 0; i < kThresholds; ++i) {
      std::vector<std::string> fields{std::to_string(picture + 1), threshold_text(i)};
      for (std::string& field : count_fields(pictures[picture][i])) fields.push_back(std::move(field));
      text += csv_line(fields);
    }
  }
  return text;
}

std::vector<CurveCounts> counts_from_csv(std::string_view text, const std::string& where) {
  const CsvTable table = parse_csv(text);
  if (table.columns != kCountColumns || table.rows.size() % kThresholds != 0)
    throw work_error(where, "is no table of counts", "run the study again");
  std::vector<CurveCounts> pictures(table.rows.size() / kThresholds);
  for (size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<std::string>& row = table.rows[i];
    pictures[i / kThresholds][i % kThresholds] = {count_in(row[2], where), count_in(row[3], where),
                                                  count_in(row[4], where), count_in(row[5], where)};
  }
  return pictures;
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
