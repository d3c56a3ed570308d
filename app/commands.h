// SPDX-License-Identifier: MIT
// The subcommands of `inkbench`: each declares its options and help, and runs after parsing. One command, one
// file.
#pragma once

#include <CLI/CLI.hpp>

namespace inkbench {

/// What a command that reported its own failure leaves for main: 0 unless set.
int& exit_status();

void add_app_command(CLI::App& app);
void add_render_command(CLI::App& app);
void add_study_command(CLI::App& app);
void add_tune_command(CLI::App& app);
void add_score_command(CLI::App& app);
void add_measure_command(CLI::App& app);
void add_explain_command(CLI::App& app);
void add_decimate_command(CLI::App& app);
void add_params_command(CLI::App& app);
void add_styles_command(CLI::App& app);
void add_passes_command(CLI::App& app);
void add_info_command(CLI::App& app);

}  // namespace inkbench
