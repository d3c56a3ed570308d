// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/hear_signals.h"
#include "app/progress_line.h"
#include "app/spec_files.h"
#include "app/terminal.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/stop.h"
#include "pipeline/base/text.h"
#include "pipeline/gl/context.h"
#include "studies/sweep/manifest.h"
#include "studies/tuning/run_tune.h"
#include "studies/tuning/tune_files.h"

namespace inkbench {
namespace {

struct TuneArguments {
  std::string spec, out, progress = "text";
  std::vector<std::string> assignments;
  int budget = 0, seed = -1;
  bool fresh = false, dry_run = false, no_report = false;
};

void list_searches() {
  for (const fs::path& path : specs_in(project_file("studies/tuning")))
    print_out("{:<42} {}\n", "studies/tuning/" + path.filename().string(),
              printable(load_tune_spec(path).purpose));
}

fs::path find_search(const std::string& name) {
  for (const fs::path& candidate :
       {fs::path(name), project_root() / name, project_root() / "studies/tuning" / (name + ".toml")}) {
    if (fs::is_regular_file(candidate)) return candidate;
  }
  throw input_error(name, "there is no such search", "`inkbench tune list` names the bundled ones");
}

std::string command_of(const TuneSpec& spec, const TuneArguments& arguments) {
  std::string command = spec_command("tune", spec.path, spec.assignments);
  if (arguments.budget > 0) command += fmt::format(" --budget {}", arguments.budget);
  if (arguments.seed >= 0) command += fmt::format(" --seed {}", arguments.seed);
  return command;
}

void print_plan(const TuneSpec& spec) {
  print_out("{}: {}\n", printable(spec.title),
            fmt::format("{} of {}, at most {} candidates, {} x {} px",
                        counted(spec.pictures.size(), "picture", "pictures"),
                        counted(spec.groups.size(), spec.group_kind, spec.group_kind + "s"),
                        with_commas(spec.budget), spec.base.image.width, spec.base.image.height));
  print_out("  as large as can be: {}\n", printable(spec.objective.text()));
  for (const SearchAxis& axis : spec.space) {
    std::vector<std::string> choices;
    for (const Value& choice : axis.choices) choices.push_back(to_text(choice));
    const std::string range = axis.is_number() ? shortest(static_cast<float>(axis.from)) + " to " +
                                                     shortest(static_cast<float>(axis.to)) +
                                                     (axis.scale == Scale::log ? ", log" : "")
                                               : join(choices, ", ");
    print_out("  {}: {}\n", axis.key, printable(range));
  }
  flush_out();
}

/// {"done":12,"total":200,"objective":0.91,"best":0.95,"values":{"combine.k_depth":"0.003"},"seconds":0.845}:
/// of the values the best ones.
std::string json_of(const TuneSpec& spec, const Trial& trial, size_t done, const Trial& best,
                    double seconds) {
  using Line = nlohmann::ordered_json;
  const auto objective = [](const Trial& of) { return of.score == kNoScore ? Line() : Line(of.score.value); };
  Line values = Line::object();
  for (size_t i = 0; i < spec.space.size(); ++i) values[spec.space[i].key] = to_text(best.values[i]);
  const Line json{{"done", done},
                  {"total", spec.budget},
                  {"objective", objective(trial)},
                  {"best", objective(best)},
                  {"values", values},
                  {"seconds", std::round(1e3 * seconds) / 1e3}};
  return json.dump(-1, ' ', false, Line::error_handler_t::replace);
}

ProgressNote note_of(const TuneSpec& spec, const Trial& trial, size_t done, const Trial& best,
                     double seconds) {
  const std::string rate =
      seconds > 0 ? fmt::format(", {:.1f} a second", static_cast<double>(done) / seconds) : "";
  return {seconds,
          fmt::format("{} / {} candidates{}, {}: best {} at {}", done, spec.budget, rate, trial.stage,
                      score_text(best.score), values_text(spec.space, best.values)),
          json_of(spec, trial, done, best, seconds)};
}

void run(const TuneSpec& spec, const TuneArguments& arguments) {
  const HeadlessContext context;
  Pipeline pipeline;
  ProgressLine line(arguments.progress == "json" ? ProgressFormat::json : ProgressFormat::text);
  const auto start = std::chrono::steady_clock::now();
  ProgressNote last;
  TuneOptions options;
  options.folder = arguments.out.empty() ? fs::path("out") / ("tune_" + spec.path.stem().string())
                                         : fs::path(arguments.out);
  options.fresh = arguments.fresh;
  options.report = !arguments.no_report;
  options.command = command_of(spec, arguments);
  options.on_progress = [&](const Trial& trial, size_t done, const Trial& best) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    last = note_of(spec, trial, done, best, seconds);
    line.show(last);
  };
  const TuneOutcome outcome = run_tune(pipeline, spec, options);
  line.finish(last);
  print_out("{}\n", printable(outcome.verdict));
  for (const std::string& sentence : outcome.marks) print_out("{}\n", printable(sentence));
  print_out("{}\n", printable(values_text(spec.space, outcome.result.tuned().values)));
  for (const fs::path& path : {outcome.preset, outcome.page}) {
    if (!path.empty()) print_out("{}\n", path.string());
  }
  flush_out();
  for (size_t i = 0; i < std::min<size_t>(outcome.problems.size(), 10); ++i)
    print_error("inkbench: warning: {}\n", printable(outcome.problems[i]));
  if (!outcome.result.stopped) return;
  print_error("inkbench: error: stopped after {} of {} candidates; the same command continues\n",
              outcome.result.trials.size(), spec.budget);
  exit_status() = 1;
}

void tune_command(const TuneArguments& arguments) {
  if (arguments.spec == "list") return list_searches();
  TuneSpec spec = load_tune_spec(find_search(arguments.spec), arguments.assignments);
  if (arguments.budget > 0) spec.budget = arguments.budget;
  if (arguments.seed >= 0) spec.seed = static_cast<uint64_t>(arguments.seed);
  print_plan(spec);
  if (!arguments.dry_run) run(spec, arguments);
}

}  // namespace

void add_tune_command(CLI::App& app) {
  auto arguments = std::make_shared<TuneArguments>();
  CLI::App* command = app.add_subcommand(
      "tune", "Search for the parameters whose lines are the best, and say how far to trust them");
  command->add_option("SPEC", arguments->spec, "Spec file (TOML), a bundled search's name, or `list`")
      ->required();
  command->add_option("--out", arguments->out, "Folder for the results; out/tune_<spec's name> without it");
  command->add_option("--budget", arguments->budget, "Candidates at most, instead of the spec's")
      ->check(CLI::Range(kLeastBudget, kMostBudget));
  command
      ->add_option("--seed", arguments->seed,
                   "Where the even cover begins, instead of the spec's; same seed, same result")
      ->check(CLI::Range(0, 1'000'000'000));
  command
      ->add_option("--set", arguments->assignments,
                   "KEY=VALUE: set a base value (`inkbench params` lists them); repeatable")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag("--dry-run", arguments->dry_run, "Check the spec and say what would be searched");
  command
      ->add_option("--progress", arguments->progress,
                   "text, or json: a line on stdout for each step, for other programs")
      ->check(CLI::IsMember({"text", "json"}));
  command->add_flag("--no-report", arguments->no_report, "Leave out charts, pictures and the page");
  command->add_flag("--fresh", arguments->fresh, "Start over instead of continuing");
  command->footer(
      "Examples:\n  inkbench tune list\n  inkbench tune studies/tuning/rabbit_k.toml --out out/rabbit_k\n"
      "  inkbench render --scene out/rabbit_k/tuned.toml --out out/tuned");
  command->callback([arguments] {
    hear_signals();
    tune_command(*arguments);
  });
}

}  // namespace inkbench
