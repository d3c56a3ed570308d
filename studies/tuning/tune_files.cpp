// SPDX-License-Identifier: MIT
#include "studies/tuning/tune_files.h"

#include <fmt/format.h>

#include "pipeline/base/text.h"
#include "pipeline/settings/settings_file.h"
#include "studies/report/chart_text.h"
#include "studies/report/csv.h"

namespace inkbench {
namespace {

/// As in a study's table: names without quotes.
std::string field_text(const Value& value) {
  const std::string* text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : to_text(value);
}

void add_values(std::vector<std::string>& row, const Values& values) {
  for (const Value& value : values) row.push_back(field_text(value));
}

/// Empty where nothing was drawn.
std::string objective_text(const Score& score) {
  return score == kNoScore ? "" : shortest(score.value);
}

std::string problem_text(const Score& score) {
  return score == kNoScore ? "could not be drawn" : "";
}

DrawingTally sum_of(const GroupTallies& groups) {
  DrawingTally sum;
  for (const std::optional<DrawingTally>& group : groups) {
    if (group) sum.add(*group);
  }
  return sum;
}

}  // namespace

// The objective stands last: gnuplot takes a row whose last field is empty for a shorter one.

std::string trace_csv(const TuneSpec& spec, const TuneResult& result) {
  const std::vector<const Measure*> measures = spec.objective.measures();
  std::vector<std::string> head{"trial", "stage"};
  for (const SearchAxis& axis : spec.space) head.push_back(axis.key);
  head.insert(head.end(), {"error", "objective", "limits_kept"});
  for (const Measure* measure : measures) head.push_back(measure->key);
  head.emplace_back("best");
  std::string text = csv_line(head);
  Score best = kNoScore;
  for (size_t i = 0; i < result.trials.size(); ++i) {
    const Trial& trial = result.trials[i];
    if (trial.is_whole && is_better(trial.score, best)) best = trial.score;
    std::vector<std::string> row{std::to_string(i + 1), trial.stage};
    add_values(row, trial.values);
    row.push_back(problem_text(trial.score));
    row.push_back(objective_text(trial.score));
    row.emplace_back(trial.score.keeps_limits() ? "true" : "false");
    const DrawingTally sum = sum_of(trial.groups);
    for (const Measure* measure : measures)
      row.push_back(trial.score == kNoScore ? "" : measure_text(*measure, sum));
    row.push_back(best.keeps_limits() ? objective_text(best) : "");
    text += csv_line(row);
  }
  return text;
}

std::string box_csv(const TuneSpec& spec, const TuneResult& result) {
  std::vector<std::string> head;
  for (const SearchAxis& axis : spec.space) head.push_back(axis.key);
  head.insert(head.end(), {"error", "objective"});
  std::string text = csv_line(head);
  for (const size_t i : result.cover) {
    const Trial& trial = result.trials[i];
    std::vector<std::string> row;
    add_values(row, trial.values);
    row.push_back(problem_text(trial.score));
    row.push_back(objective_text(trial.score));
    text += csv_line(row);
  }
  return text;
}

std::string profiles_csv(const TuneResult& result) {
  std::string text = csv_line(std::vector<std::string>{"parameter", "from", "value", "error", "objective"});
  for (const AxisWorth& axis : result.axes) {
    for (const auto& [from, profile] : {std::pair("default", &axis.alone), {"tuned", &axis.around}}) {
      for (size_t k = 0; k < profile->values.size(); ++k) {
        const Score& score = profile->scores[k];
        text += csv_line(std::vector<std::string>{axis.key, from, field_text(profile->values[k]),
                                                  problem_text(score), objective_text(score)});
      }
    }
  }
  return text;
}

std::string tuned_preset(const TuneSpec& spec, const TuneResult& result) {
  const Settings tuned = with_values(spec.base, spec.space, result.tuned().values);
  return fmt::format("{}: tuned\n# {}: {} = {}\n# {}\n", kPresetMark, one_line(spec.title),
                     spec.objective.text(), score_text(result.tuned().score),
                     values_text(spec.space, result.tuned().values)) +
         settings_text(tuned);
}

std::string score_text(const Score& score) {
  if (score == kNoScore) return "-";
  const std::string value = fmt::format("{:.3f}", score.value);
  return score.keeps_limits() ? value : value + " (misses its limits)";
}

}  // namespace inkbench
