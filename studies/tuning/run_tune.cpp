// SPDX-License-Identifier: MIT
#include "studies/tuning/run_tune.h"

#include <chrono>
#include <nlohmann/json.hpp>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "studies/sweep/run_study.h"
#include "studies/sweep/study_folder.h"
#include "studies/tuning/mark_report.h"
#include "studies/tuning/trial_meter.h"
#include "studies/tuning/tune_files.h"

namespace inkbench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Score& score) {
  if (score == kNoScore) return nullptr;
  return {{"objective", score.value}, {"limits_kept", score.keeps_limits()}};
}

Json json_of(const TuneSpec& spec, const Values& values) {
  Json json = Json::object();
  for (size_t i = 0; i < spec.space.size(); ++i) json[spec.space[i].key] = to_text(values[i]);
  return json;
}

Json json_of(const TuneSpec& spec, const Trial& trial) {
  Json json = json_of(trial.score);
  json["values"] = json_of(spec, trial.values);
  return json;
}

Json json_of(const Compliance& drawing) {
  Json strokes = Json::array();
  for (const PictureStrokes& picture : drawing.pictures) {
    for (const MarkedStroke& stroke : picture.strokes)
      strokes.push_back({{"picture", picture.picture},
                         {"kind", stroke.is_wanted ? "wanted" : "unwanted"},
                         {"at", {stroke.centre.x, stroke.centre.y}},
                         {"as_asked_px", stroke.counts.matched},
                         {"px", stroke.counts.total},
                         {"satisfied", stroke.is_satisfied()}});
  }
  const std::optional<double> value = drawing.tally.value();
  return {{"drawing", drawing.name}, {"marks", value ? Json(*value) : Json()}, {"strokes", strokes}};
}

Json json_of(const MarkReport& report) {
  Json methods = Json::array(), better = Json::array();
  for (const Compliance& method : report.methods) methods.push_back(json_of(method));
  for (const Compliance* method : report.better()) better.push_back(method->name);
  return {{"sentences", mark_sentences(report)},
          {"default", json_of(report.initial)},
          {"tuned", json_of(report.tuned)},
          {"methods", methods},
          {"better", better}};
}

std::string result_json(const TuneSpec& spec, const TuneResult& result, const PaperScores& paper,
                        const std::string& verdict, const MarkReport* marks, const TuneCost& cost) {
  Json axes = Json::array(), left_out = Json::array();
  for (const AxisWorth& axis : result.axes) {
    if (axis.around.values.empty()) continue;
    Json entry{{"parameter", axis.key},
               {"matters", axis.matters()},
               {"over_its_range", axis.spread},
               {"alone", json_of(axis.alone_score)},
               {"best_alone", to_text(axis.best_alone)},
               {"without", json_of(axis.without)}};
    if (axis.equally_good) entry["equally_good"] = {axis.equally_good->first, axis.equally_good->second};
    axes.push_back(std::move(entry));
  }
  for (size_t g = 0; g < result.left_out.size(); ++g) {
    const LeftOut& left = result.left_out[g];
    left_out.push_back({{spec.group_kind, left.group},
                        {"values", json_of(spec, left.values)},
                        {"trained", json_of(left.trained)},
                        {"tuned", json_of(left.tuned)},
                        {"default", json_of(left.start)},
                        {"paper", json_of(paper.groups[g])}});
  }
  Json json{{"verdict", verdict},
            {"objective", spec.objective.text()},
            {"paper", json_of(paper.all)},
            {"default", json_of(spec, result.initial())},
            {"tuned", json_of(spec, result.tuned())}};
  json["leave_one_out"] = result.left_out_tuned ? json_of(*result.left_out_tuned) : Json();
  json["gained"] = result.is_gain() ? Json(*result.is_gain()) : Json();
  json["plateau"] = result.plateau;
  if (marks != nullptr) json["marks"] = json_of(*marks);
  json["parameters"] = axes;
  json["left_out"] = left_out;
  json["stopped"] = result.stopped;
  json["cost"] = {{"candidates", result.trials.size()}, {"budget", spec.budget}, {"seed", spec.seed},
                  {"drawings_measured", cost.measured}, {"known", cost.known},   {"seconds", cost.seconds}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

class TuneRun {
 public:
  TuneRun(Pipeline& pipeline, const TuneSpec& spec, const TuneOptions& options)
      : pipeline_(pipeline), spec_(spec), options_(options) {}

  TuneOutcome run() {
    TuneOutcome outcome;
    {
      const FolderLock lock(options_.folder);
      search(outcome);
    }
    if (options_.report && !outcome.result.stopped) report(outcome);
    return outcome;
  }

 private:
  fs::path file(const char* name) const { return options_.folder / name; }

  void search(TuneOutcome& outcome) {
    const auto start = std::chrono::steady_clock::now();
    std::error_code error;
    if (options_.fresh) fs::remove(file("trials.txt"), error);
    pipeline_.check_room(spec_.base.image);
    TrialMeter meter(pipeline_, spec_, file("trials.txt"));
    paper_ = paper_scores(meter);  // first: once stopped nothing is drawn
    const MeasureCandidates measure = [&](const std::vector<Values>& candidates,
                                          const std::vector<bool>& wanted) {
      return meter.measure(candidates, wanted);
    };
    try {
      outcome.result = tune(problem_of(spec_), measure, options_.on_progress);
    } catch (const Error& failed) {
      if (meter.problems().empty()) throw;
      throw input_error("tune", "no candidate could be drawn: " + meter.problems().front());
    }
    outcome.problems = meter.problems();
    if (spec_.has_marks()) {
      marks_ = look_at_marks(pipeline_, spec_, outcome.result);
      outcome.marks = mark_sentences(*marks_);
    }
    outcome.cost = {meter.measured(), meter.known(),
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
    outcome.verdict = verdict_of(spec_, outcome.result, paper_);
    outcome.preset = file("tuned.toml");
    write_file_atomically(outcome.preset, tuned_preset(spec_, outcome.result));
    write_file_atomically(file("trace.csv"), trace_csv(spec_, outcome.result));
    write_file_atomically(file("box.csv"), box_csv(spec_, outcome.result));
    write_file_atomically(file("profiles.csv"), profiles_csv(outcome.result));
    write_file_atomically(file("tuning.json"), result_json(spec_, outcome.result, paper_, outcome.verdict,
                                                           marks_ ? &*marks_ : nullptr, outcome.cost));
  }

  PaperScores paper_scores(TrialMeter& meter) {
    std::vector<DrawingTally> groups(spec_.groups.size());
    DrawingTally all;
    for (size_t p = 0; p < spec_.pictures.size(); ++p) {
      const TunePicture& picture = spec_.pictures[p];
      const DrawingTally tally = meter.tally(p, papers_settings(picture_settings(spec_, picture)));
      groups[picture.group].add(tally);
      all.add(tally);
    }
    PaperScores scores{score_of(spec_.objective, all), {}};
    for (const DrawingTally& group : groups) scores.groups.push_back(score_of(spec_.objective, group));
    return scores;
  }

  void report(TuneOutcome& outcome) {
    StudyOptions study;
    study.folder = options_.folder;
    study.extras.kind = "tune";
    study.extras.command = options_.command;
    study.extras.verdict = outcome.verdict;
    study.extras.tables = tune_tables(spec_, outcome.result, paper_, outcome.cost);
    if (marks_) study.extras.tables.insert(study.extras.tables.begin() + 1, mark_table(*marks_));
    study.extras.links = {{"tuned.toml", "tuned.toml"},
                          {"trace.csv", "trace.csv"},
                          {"box.csv", "box.csv"},
                          {"profiles.csv", "profiles.csv"},
                          {"tuning.json", "tuning.json"}};
    for (const Chart& chart : tune_charts(spec_, outcome.result)) {
      try {
        study.extras.charts.push_back(draw_chart(chart, options_.folder));
      } catch (const Error& error) {
        outcome.problems.push_back("chart " + chart.name + ": " + error.what());
      }
    }
    const StudyResult pictures = run_study(pipeline_, before_and_after(spec_, outcome.result), study);
    outcome.page = pictures.page;
    outcome.problems.insert(outcome.problems.end(), pictures.failures.begin(), pictures.failures.end());
  }

  Pipeline& pipeline_;
  const TuneSpec& spec_;
  const TuneOptions& options_;
  PaperScores paper_;
  std::optional<MarkReport> marks_;
};

}  // namespace

TuneOutcome run_tune(Pipeline& pipeline, const TuneSpec& spec, const TuneOptions& options) {
  return TuneRun(pipeline, spec, options).run();
}

}  // namespace inkbench
