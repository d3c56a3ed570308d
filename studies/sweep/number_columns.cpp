// SPDX-License-Identifier: MIT
#include "studies/sweep/number_columns.h"

#include "studies/sweep/spec.h"

namespace inkbench {

std::vector<std::string> known_measures() {
  std::vector<std::string> names;
  for (const Measure& measure : measure_table()) {
    if (!measure.in_every_study && !measure.of_marks()) names.push_back(measure.key);
  }
  return names;
}

std::vector<std::string> every_measure(bool along_path) {
  std::vector<std::string> names = known_measures();
  std::erase_if(names, [&](const std::string& name) {
    const Measure& measure = *find_measure(name);
    return measure.needs == Need::causes || measure.needs == Need::strengths ||
           (!along_path && measure.of_path());
  });
  return names;
}

std::vector<const Measure*> study_measures(const StudySpec& spec) {
  std::vector<const Measure*> measures;
  for (const Measure& measure : measure_table()) {
    if (measure.in_every_study) measures.push_back(&measure);
  }
  for (const std::string& key : spec.measures) measures.push_back(find_measure(key));
  return measures;
}

std::vector<std::string> number_columns(const StudySpec& spec) {
  std::vector<std::string> columns;
  for (const Measure* measure : study_measures(spec)) columns.push_back(measure->key);
  return columns;
}

MeasureNeeds needs_of(const StudySpec& spec) {
  MeasureNeeds needs;
  for (const Measure* measure : study_measures(spec)) needs.add(*measure);
  return needs;
}

std::vector<std::string> cell_numbers(const StudySpec& spec, const DrawingTally& tally) {
  std::vector<std::string> numbers;
  for (const Measure* measure : study_measures(spec)) numbers.push_back(measure_text(*measure, tally));
  return numbers;
}

}  // namespace inkbench
