// SPDX-License-Identifier: MIT
#include "studies/tuning/tune_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/base/text.h"
#include "studies/sweep/labels.h"
#include "studies/tuning/tune_files.h"

namespace inkbench {
namespace {

constexpr const char* kPaper = "paper";
constexpr const char* kDefault = "default";
constexpr const char* kTuned = "tuned";

std::string objective_name(const TuneSpec& spec) {
  const Objective& objective = spec.objective;
  const bool is_f_alone = objective.terms.size() == 1 && objective.terms.front().measure->key == "f1" &&
                          objective.terms.front().weight == 1;
  return is_f_alone ? "F" : "the objective";
}

std::string number_text(double number) {
  return fmt::format("{:.4g}", number);
}

PageTable score_table(const TuneSpec& spec, const TuneResult& result, const PaperScores& paper) {
  PageTable table{"Scores",
                  "The objective is " + spec.objective.text() + ", its counts pooled over " +
                      counted(spec.pictures.size(), "picture", "pictures") + ".",
                  {"values", "objective"},
                  {}};
  for (const SearchAxis& axis : spec.space) table.columns.push_back(axis.key);
  const auto row = [&](const std::string& name, const Score& score, const Values* values) {
    std::vector<std::string> fields{name, score_text(score)};
    for (size_t i = 0; i < spec.space.size(); ++i)
      fields.push_back(values == nullptr ? "" : to_text((*values)[i]));
    table.rows.push_back(std::move(fields));
  };
  row("paper: its method, its coefficients", paper.all, nullptr);
  row("default: as the scene has them", result.initial().score, &result.initial().values);
  row("tuned", result.tuned().score, &result.tuned().values);
  if (result.left_out_tuned) row("leave-one-out", *result.left_out_tuned, nullptr);
  return table;
}

std::string worth_note(const AxisWorth& axis) {
  if (!axis.has_effect) return "has no effect beside the other tuned values";
  return axis.matters() ? "" : "does not matter: nothing changes over its whole range";
}

PageTable worth_table(const TuneSpec& spec, const TuneResult& result) {
  PageTable table{
      "What each parameter is worth",
      "Alone: the default with this one parameter at the value that does most for it. Without: the tuned "
      "values with this one as the default has it. Equally good: how far it can be moved from its tuned "
      "value, alone, before more than 0.01 is lost.",
      {"parameter", "default", "tuned", "equally good", "alone", "without", "over its range", ""},
      {}};
  for (size_t i = 0; i < result.axes.size(); ++i) {
    const AxisWorth& axis = result.axes[i];
    if (axis.around.values.empty()) continue;
    const std::string range = axis.equally_good ? number_text(axis.equally_good->first) + " to " +
                                                      number_text(axis.equally_good->second)
                                                : "";
    table.rows.push_back({axis.key, to_text(result.initial().values[i]), to_text(result.tuned().values[i]),
                          range, score_text(axis.alone_score) + " at " + to_text(axis.best_alone),
                          score_text(axis.without), fmt::format("{:.3f}", axis.spread), worth_note(axis)});
  }
  if (table.rows.empty())
    table.note = "The budget of " + std::to_string(spec.budget) + " was too small to tell.";
  return table;
}

PageTable left_out_table(const TuneSpec& spec, const TuneResult& result, const PaperScores& paper) {
  PageTable table{
      "Leave-one-out",
      "Each " + spec.group_kind + " is judged with values that were searched for without it.",
      {spec.group_kind, "trained on the others", "tuned, on it", "default, on it", "paper, on it"},
      {}};
  for (const SearchAxis& axis : spec.space) table.columns.push_back(axis.key);
  for (size_t g = 0; g < result.left_out.size(); ++g) {
    const LeftOut& left = result.left_out[g];
    std::vector<std::string> row{left.group, score_text(left.trained), score_text(left.tuned),
                                 score_text(left.start), score_text(paper.groups[g])};
    for (const Value& value : left.values) row.push_back(to_text(value));
    table.rows.push_back(std::move(row));
  }
  return table;
}

PageTable cost_table(const TuneSpec& spec, const TuneResult& result, const TuneCost& cost) {
  const auto count = [](size_t number) { return with_commas(static_cast<long long>(number)); };
  return {"Cost",
          "",
          {"candidates", "budget", "drawings measured", "known without measuring", "time"},
          {{count(result.trials.size()), count(static_cast<size_t>(spec.budget)), count(cost.measured),
            count(cost.known), fmt::format("{:.1f} s", cost.seconds)}}};
}

ChartColumn number_column(const std::string& name, const std::string& label, Scale scale = Scale::linear) {
  ChartColumn column;
  column.name = name;
  column.label = label;
  column.scale = scale;
  return column;
}

ChartColumn text_column(const std::string& name) {
  ChartColumn column;
  column.name = column.label = name;
  column.is_text = column.names_itself = true;
  return column;
}

Chart chart_of(const TuneSpec& spec, const std::string& name, const std::string& title,
               const std::string& table) {
  Chart chart;
  chart.name = name;
  chart.title = title;
  chart.study = spec.title;
  chart.table = table;
  return chart;
}

std::vector<size_t> number_sides(const SearchSpace& space) {
  std::vector<size_t> sides;
  for (size_t i = 0; i < space.size(); ++i) {
    if (space[i].is_number()) sides.push_back(i);
  }
  return sides;
}

/// Two numbers and nothing else: the cover is a grid.
std::optional<Chart> box_chart(const TuneSpec& spec) {
  if (spec.space.size() != 2 || number_sides(spec.space).size() != 2) return std::nullopt;
  Chart chart = chart_of(spec, "box", "The objective over the box", "box.csv");
  chart.kind = ChartKind::heatmap;
  chart.x = number_column(spec.space[0].key, spec.space[0].key, spec.space[0].scale);
  chart.y = {number_column(spec.space[1].key, spec.space[1].key, spec.space[1].scale)};
  chart.value = number_column("objective", "objective");
  chart.value->is_measured = true;
  chart.mark_within = kPlateau;
  chart.x_label = spec.space[0].key;
  chart.y_label = spec.space[1].key;
  return chart;
}

Chart profile_chart(const TuneSpec& spec, const SearchAxis& axis, size_t number) {
  Chart chart =
      chart_of(spec, "profile_" + std::to_string(number + 1), axis.key + ", moved alone", "profiles.csv");
  chart.x = number_column("value", axis.key, axis.scale);
  chart.y = {number_column("objective", "objective")};
  chart.by = text_column("from");
  chart.where = {{text_column("parameter"), {axis.key}}};
  chart.scale_x = axis.scale;
  chart.x_label = axis.key;
  chart.y_label = "objective";
  return chart;
}

Chart trace_chart(const TuneSpec& spec) {
  Chart chart = chart_of(spec, "trace", "The best so far", "trace.csv");
  chart.x = number_column("trial", "candidate");
  chart.y = {number_column("best", "objective")};
  chart.x_label = "candidates";
  chart.y_label = "objective";
  return chart;
}

}  // namespace

std::string verdict_of(const TuneSpec& spec, const TuneResult& result, const PaperScores& paper) {
  const std::string name = objective_name(spec);
  const std::string tuned = score_text(result.tuned().score), initial = score_text(result.initial().score);
  const bool is_papers = papers_settings(spec.base).edges.method == spec.base.edges.method &&
                         paper.all == result.initial().score;
  const std::string than = is_papers ? initial + " with the paper's coefficients, which are the default"
                                     : fmt::format("{} with the default, {} with the paper's method", initial,
                                                   score_text(paper.all));
  const std::string stopped = result.stopped ? " The search was stopped early: this is the best so far." : "";
  const std::optional<bool> gain = result.is_gain();
  if (!gain)
    return fmt::format(
        "Tuned, {} is {}: {}. It is judged on what it was tuned on, so how it does elsewhere is not known.{}",
        name, tuned, than, stopped);
  const std::string left_out = score_text(*result.left_out_tuned);
  if (!*gain)
    return fmt::format(
        "Nothing was gained: judged on a {} that it was not tuned on, {} is {}; {}. (On what it was tuned "
        "on: {}.){}",
        spec.group_kind, name, left_out, than, tuned, stopped);
  return fmt::format(
      "Tuned and judged on a {} that it was not tuned on, {} is {}; {}. (On what it was tuned on: {}.){}",
      spec.group_kind, name, left_out, than, tuned, stopped);
}

std::vector<PageTable> tune_tables(const TuneSpec& spec, const TuneResult& result, const PaperScores& paper,
                                   const TuneCost& cost) {
  std::vector<PageTable> tables{score_table(spec, result, paper), worth_table(spec, result)};
  if (!result.left_out.empty()) tables.push_back(left_out_table(spec, result, paper));
  tables.push_back({"Plateau",
                    fmt::format("{:.1f} % of the box, by {} points spread evenly over it, is within 0.01 of "
                                "the best: the larger, the "
                                "less the exact values matter.",
                                100 * result.plateau, result.cover.size()),
                    {},
                    {}});
  tables.push_back(cost_table(spec, result, cost));
  return tables;
}

std::vector<Chart> tune_charts(const TuneSpec& spec, const TuneResult& result) {
  std::vector<Chart> charts;
  if (const std::optional<Chart> box = box_chart(spec)) charts.push_back(*box);
  for (const size_t side : number_sides(spec.space)) {
    if (side < result.axes.size() && !result.axes[side].around.values.empty())
      charts.push_back(profile_chart(spec, spec.space[side], side));
  }
  charts.push_back(trace_chart(spec));
  return charts;
}

Settings papers_settings(const Settings& settings) {
  Settings paper = settings;
  paper.edges = {};
  paper.combine = {};
  return paper;
}

StudySpec before_and_after(const TuneSpec& spec, const TuneResult& result) {
  StudySpec study;
  study.path = spec.path;
  study.text = spec.text;
  study.title = spec.title;
  study.purpose = spec.purpose;
  study.base = spec.base;
  study.show = {BufferName::final, BufferName::lines};
  const std::vector<const Measure*> measures = spec.objective.measures();
  if (MeasureNeeds::of(measures).reference_lines()) {
    for (const char* key : {"f1", "precision", "recall"}) study.measures.emplace_back(key);
  }
  for (const Measure* measure : measures) {
    const bool is_there =
        std::find(study.measures.begin(), study.measures.end(), measure->key) != study.measures.end();
    if (!is_there && !measure->in_every_study && !measure->of_marks()) study.measures.push_back(measure->key);
  }
  study.assignments = spec.assignments;
  if (spec.pictures.size() > 1 || !spec.pictures.front().set.empty()) {
    for (const TunePicture& picture : spec.pictures) study.views.push_back({picture.name, picture.set});
  }
  Settings paper = papers_settings(spec.base);
  const Settings base = spec.base;
  NamedSet papers{kPaper, {}};
  for (const ConstParam& param : list_params(std::as_const(paper))) {
    const Value old = find_param(base, param.key, param.key).value();
    if (param.value() != old) papers.set.push_back({param.key, param.value()});
  }
  const auto set_of = [&](const char* name, const Values& values) {
    NamedSet set{name, {}};
    for (size_t i = 0; i < spec.space.size(); ++i) set.set.push_back({spec.space[i].key, values[i]});
    return set;
  };
  // What a variant leaves as it is, the others set, too.
  NamedSet initial = set_of(kDefault, result.initial().values), tuned = set_of(kTuned, result.tuned().values);
  study.variants = {papers, initial, tuned};
  return study;
}

}  // namespace inkbench
