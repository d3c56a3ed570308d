// The measures of line quality, by the names under which `inkbench score` and a study's data.csv give them.
// In: a tally of one view or of several pooled. Out: numbers, and what each is called and means.
// Definitions and conventions: docs/measures.md.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "studies/measures/tally.h"

namespace inkbench {

struct Measures {
  bool empty = false;  ///< Neither prediction nor reference has a line.
  int64_t matched = 0, predicted = 0, referenced = 0;
  double precision = 0, recall = 0, f1 = 0;
  double f1_t1 = 0, f1_diag = 0;
  double chamfer = 0;
  std::optional<double> hd95;  ///< None where lines are infinitely far from the other side's, which has none.
  double baddeley = 0;
  double breaks_per_100px = 0, mean_gap_px = 0;
  int64_t components = 0;
  double ends_per_100px = 0;
  double thickness_px = 0, thickness_cov = 0;
  std::optional<double> jaggedness_px, bias_px;  ///< None without polylines that have ink beside them.
  double ink = 0;
};

Measures measures_of(const LineTally& tally);

/// The F alone; 1 where neither has a line, 0 where one has none.
double f1_of(const F1Counts& counts);

/// One measure's name and how to read it.
struct MeasureInfo {
  std::string_view key;  ///< JSON key and CSV column.
  std::string_view help;
  bool is_count = false;
  std::optional<double> (*value)(const Measures&) = nullptr;
};

/// All of them except `empty`, in the order of measures.md.
std::span<const MeasureInfo> measure_list();

/// The value as shortest text that reads back exactly; counts without a point; "" where there is none.
std::string measure_text(const MeasureInfo& info, const Measures& measures);

/// One JSON object on one line: `empty` as a boolean, then every measure; null where there is none.
std::string measures_json(const Measures& measures);

/// A table for people: key, value, meaning.
std::string measures_table(const Measures& measures);

}  // namespace inkbench
