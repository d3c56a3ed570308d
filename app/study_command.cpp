// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/hear_signals.h"
#include "app/progress_line.h"
#include "app/spec_files.h"
#include "app/terminal.h"
#include "app/workbench/study_plan.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/stop.h"
#include "pipeline/base/text.h"
#include "pipeline/gl/context.h"
#include "studies/sweep/run_study.h"
#include "studies/sweep/verify_study.h"

namespace inkbench {
namespace {

struct StudyArguments {
  std::string spec, folder, out, progress = "text";
  std::vector<std::string> assignments;
  bool dry_run = false, fresh = false, fail_fast = false;
};

void list_studies() {
  for (const char* folder : {"studies", "studies/figures"}) {
    for (const fs::path& path : specs_in(project_file(folder))) {
      const std::string name = std::string(folder) + "/" + path.filename().string();
      print_out("{:<42} {}\n", name, printable(load_spec(path).purpose));
    }
  }
  print_out("\n`inkbench study studies/figures` makes all figures.\n");
}

/// A spec as it was named: a path, or a bundled one's path or short name.
fs::path find_spec(const std::string& name) {
  for (const fs::path& candidate :
       {fs::path(name), project_root() / name, project_root() / "studies" / (name + ".toml"),
        project_root() / "studies/figures" / (name + ".toml")}) {
    if (fs::exists(candidate)) return candidate;
  }
  throw input_error(name, "there is no such study", "`inkbench study list` names the bundled ones");
}

void print_plan(const StudySpec& spec) {
  print_out("{}: {}\n", printable(spec.title), plan_text(spec));
  flush_out();
}

void print_cells(const StudySpec& spec) {
  constexpr size_t kShown = 50;
  const size_t count = cell_count(spec);
  for (size_t i = 0; i < std::min(count, kShown); ++i)
    print_out("  {:>5}  {}\n", i + 1, printable(make_cell(spec, i).name));
  if (count > kShown) print_out("  ... and {} more\n", with_commas(static_cast<long long>(count - kShown)));
}

/// Runs one study; returns whether all of it worked.
bool run_one(Pipeline& pipeline, const StudySpec& spec, const fs::path& folder,
             const StudyArguments& arguments) {
  ProgressLine line(arguments.progress == "json" ? ProgressFormat::json : ProgressFormat::text);
  line.begin(note_of(StudyProgress{.total = cell_count(spec)}));
  StudyOptions options;
  options.folder = folder;
  options.fresh = arguments.fresh;
  options.fail_fast = arguments.fail_fast;
  options.on_progress = [&](const StudyProgress& progress) { line.show(note_of(progress)); };
  const StudyResult result = run_study(pipeline, spec, options);
  line.finish(note_of(result.progress));
  for (const fs::path& grid : result.grids) print_out("{}\n", grid.string());
  for (const DrawnChart& chart : result.charts) print_out("{}\n", chart.png.string());
  if (!result.page.empty()) print_out("{}\n", result.page.string());
  flush_out();
  for (size_t i = 0; i < std::min<size_t>(result.failures.size(), 10); ++i) {
    print_error("inkbench: error: {}\n", result.failures[i]);
  }
  if (result.progress.failed > 0) {
    print_error("inkbench: error: {} of {} cells failed; the same command tries them again\n",
                result.progress.failed, result.progress.total);
  }
  if (result.stopped) {
    print_error("inkbench: error: stopped after {} of {} cells; the same command continues\n",
                result.progress.done, result.progress.total);
  }
  return result.failures.empty() && !result.stopped;
}

void verify(const StudyArguments& arguments) {
  if (arguments.folder.empty())
    throw input_error("study verify", "which folder?", "give the one that `inkbench study --out` wrote");
  const StudyCheck check = verify_study(arguments.folder);
  for (const std::string& problem : check.problems) print_out("{}\n", printable(problem));
  const auto count = [](size_t number) { return with_commas(static_cast<long long>(number)); };
  print_out("{}: {}, {} cells, {} files compared, {} problems\n", printable(arguments.folder), check.state,
            count(check.cells), count(check.files), count(check.problems.size()));
  if (check.problems.empty()) return;
  exit_status() = fail(printable(arguments.folder) + ": is not what was written; the study's command makes " +
                           "again what was changed",
                       1);
}

void study(const StudyArguments& arguments) {
  if (arguments.spec == "list") return list_studies();
  if (arguments.spec == "verify") return verify(arguments);
  if (!arguments.folder.empty())
    throw input_error(arguments.folder, "a second argument, which only verify takes",
                      "give the folder with --out");
  const fs::path path = find_spec(arguments.spec);
  const bool is_folder = fs::is_directory(path);
  const std::vector<fs::path> paths = is_folder ? specs_in(path) : std::vector{path};
  if (paths.empty())
    throw input_error(path.string(), "holds no studies",
                      "a folder of .toml files, or one of them, is needed");
  const fs::path named = path.has_filename() ? path : path.parent_path();
  const fs::path base = arguments.out.empty() ? fs::path("out") / named.stem() : fs::path(arguments.out);

  std::vector<StudySpec> specs;
  for (const fs::path& spec_path : paths) {
    specs.push_back(load_spec(spec_path, arguments.assignments));
    print_plan(specs.back());
    check_cells(specs.back());
    if (arguments.dry_run) print_cells(specs.back());
  }
  if (arguments.dry_run) return;

  const HeadlessContext context;
  Pipeline pipeline;
  for (const StudySpec& spec : specs) {
    const bool ok = run_one(pipeline, spec, is_folder ? base / spec.path.stem() : base, arguments);
    if (!ok) exit_status() = 1;
    if (!ok && (stop_asked() || arguments.fail_fast)) return;
  }
}

}  // namespace

int& exit_status() {
  static int status = 0;
  return status;
}

void add_study_command(CLI::App& app) {
  auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command =
      app.add_subcommand("study", "Run a study: sweep parameters, write a grid, cells and a table");
  command
      ->add_option("SPEC", arguments->spec,
                   "Spec file (TOML), a folder of them, a bundled study's name, `list` or `verify`")
      ->required();
  command->add_option("DIR", arguments->folder,
                      "After `verify`: the folder of results to compare with its hashes");
  command->add_option("--out", arguments->out, "Folder for the results; out/<spec's name> without it");
  command
      ->add_option("--set", arguments->assignments,
                   "KEY=VALUE: set a base value (`inkbench params` lists them); repeatable")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag("--dry-run", arguments->dry_run, "Check the spec and say what would run");
  command
      ->add_option("--progress", arguments->progress,
                   "text, or json: a line on stdout for each step, for other programs")
      ->check(CLI::IsMember({"text", "json"}));
  command->add_flag("--fresh", arguments->fresh, "Start over instead of continuing");
  command->add_flag("--fail-fast", arguments->fail_fast, "Stop at the first cell that fails");
  command->footer(
      "Examples:\n  inkbench study list\n  inkbench study studies/k_sweep.toml --out out/k_sweep\n"
      "  inkbench study verify out/k_sweep\n"
      "  inkbench study studies/figures");
  command->callback([arguments] {
    hear_signals();
    study(*arguments);
  });
}

}  // namespace inkbench
