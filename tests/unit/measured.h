// SPDX-License-Identifier: MIT
// The measures of line maps by their keys, for tests.
#pragma once

#include <string>
#include <string_view>

#include "studies/measures/measures.h"

namespace inkbench {

class Measured {
 public:
  explicit Measured(const LineTally& lines) { tally_.lines = lines; }
  explicit Measured(const DrawingTally& tally) : tally_(tally) {}
  explicit Measured(const LinesToMeasure& lines) : tally_(tally_maps(lines)) {}

  const DrawingTally& tally() const { return tally_; }
  bool empty() const { return tally_.lines.empty(); }
  bool has(std::string_view key) const { return find_measure(key)->value(tally_).has_value(); }
  /// Throws where there is no value.
  double operator[](std::string_view key) const { return find_measure(key)->value(tally_).value(); }
  std::string json() const { return measures_json(measures_of_maps(), tally_); }

 private:
  DrawingTally tally_;
};

}  // namespace inkbench
