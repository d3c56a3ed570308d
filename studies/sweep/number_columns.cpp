#include "studies/sweep/number_columns.h"

#include "pipeline/lines/lines.h"
#include "studies/measures/ladder_measures.h"
#include "studies/measures/measures.h"
#include "studies/sweep/spec.h"

namespace inkbench {

std::vector<std::string> known_measures() {
  std::vector<std::string> names{"faces", "empty"};
  for (const MeasureInfo& info : measure_list()) {
    if (info.key != "ink") names.emplace_back(info.key);
  }
  for (const std::string_view line_class : kLineClassNames)
    names.push_back("recall_" + std::string(line_class));
  names.emplace_back("f1_detector");
  for (const LadderMeasureInfo& info : ladder_measure_list()) names.emplace_back(info.key);
  return names;
}

std::vector<std::string> number_columns(const StudySpec& spec) {
  std::vector<std::string> columns{"ink", "ink_px"};
  columns.insert(columns.end(), spec.measures.begin(), spec.measures.end());
  return columns;
}

}  // namespace inkbench
