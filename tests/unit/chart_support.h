// SPDX-License-Identifier: MIT
// What the tests of charts share: columns and tables written down shortly.
#pragma once

#include <string>
#include <vector>

#include "studies/report/chart.h"

namespace inkbench {

inline ChartColumn number(const std::string& name, Scale scale = Scale::linear) {
  return {.name = name, .label = name, .scale = scale};
}

inline ChartColumn names(const std::string& name) {
  return {.name = name, .label = name, .is_text = true};
}

inline ChartColumn measured(const std::string& name) {
  return {.name = name, .label = name, .is_measured = true};
}

/// A chart of f1 (and whatever the test adds) against `x`.
inline Chart lines_chart(const ChartColumn& x, const std::string& y = "f1") {
  return {.name = "c",
          .title = "T",
          .study = "S",
          .x = x,
          .y = {measured(y)},
          .x_label = x.label,
          .y_label = y,
          .scale_x = x.scale};
}

inline Chart heat_chart(const ChartColumn& x, const ChartColumn& y) {
  Chart chart = lines_chart(x);
  chart.kind = ChartKind::heatmap;
  chart.y = {y};
  chart.value = measured("f1");
  chart.value_label = "f1";
  return chart;
}

/// A head and rows, fields parted by commas.
inline CsvTable table_of(const std::string& text) {
  return parse_csv(text);
}

}  // namespace inkbench
