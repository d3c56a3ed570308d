// SPDX-License-Identifier: MIT
// The command line: parses, runs one subcommand, and turns errors into one message and an exit status
// (0; 1 the work failed; 2 bad usage or bad input).
#include <csignal>
#include <new>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/terminal.h"
#include "pipeline/base/error.h"
#include "pipeline/base/stop.h"

namespace {

using inkbench::fail;

/// An empty text is a variable of a script that was not set, not a wish to do without.
void refuse_empty_values(CLI::App& app) {
  const auto is_something = [](const std::string& text) {
    return text.empty() ? std::string("is given as an empty text; leave it out or give a value") : "";
  };
  for (CLI::App* const command : app.get_subcommands([](CLI::App*) { return true; })) {
    for (CLI::Option* const option : command->get_options()) {
      if (option->get_expected_max() > 0 && !option->check_name("--help")) option->check(is_something);
    }
  }
}

int run(int argc, char** argv) {
  CLI::App app("inkbench: a workbench for tuning and evaluating cartoon line rendering", "inkbench");
  app.set_version_flag("--version", "inkbench " INKBENCH_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  app.footer(
      "Example:\n  inkbench render --set combine.k_depth=0.001 --buffers final,combined_edges --out "
      "out/first\n\n"
      "`inkbench COMMAND --help` explains a command.");
  inkbench::add_app_command(app);
  inkbench::add_render_command(app);
  inkbench::add_study_command(app);
  inkbench::add_tune_command(app);
  inkbench::add_score_command(app);
  inkbench::add_measure_command(app);
  inkbench::add_explain_command(app);
  inkbench::add_decimate_command(app);
  inkbench::add_params_command(app);
  inkbench::add_styles_command(app);
  inkbench::add_passes_command(app);
  inkbench::add_info_command(app);
  refuse_empty_values(app);
  try {
    app.parse(argc, argv);
    return inkbench::exit_status();
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    std::string text = error.what();
    if (error.get_name() == "RequiredError" && app.get_subcommands().empty()) {
      const std::vector<std::string> words = app.remaining();
      text = (words.empty() ? "which command?" : "there is no '" + words.front() + "'; which command?") +
             " app, render, study, score, measure, decimate, params or info";
    }
    return fail(text + "; `inkbench --help` shows how it is used", 2);
  }
}

/// The exit status, whatever is thrown.
int guarded_run(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const inkbench::Error& error) {
    return fail(error.what(), error.kind() == inkbench::ErrorKind::input ? 2 : 1);
  } catch (const inkbench::Stopped&) {
    return fail("stopped before the work was done", 1);
  } catch (const std::bad_alloc&) {
    return fail("out of memory; choose a smaller image or mesh", 1);
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  inkbench::open_closed_descriptors();
  std::signal(SIGXFSZ, SIG_IGN);  // a write past the file size limit is an error that we report, not a death
  std::signal(SIGPIPE, SIG_IGN);
  return inkbench::finish_output(guarded_run(argc, argv));
}
