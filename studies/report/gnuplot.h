// SPDX-License-Identifier: MIT
// Runs gnuplot on a script. In: the script's file, where its pictures go. Out: the pictures, or an error that
// holds what gnuplot said.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace inkbench {

/// Runs `script` with gnuplot's variable `out` (the path before the names of the files that it writes) set to
/// `folder`/, and returns what gnuplot said besides: warnings, as a rule nothing. The user's own gnuplot
/// settings do not count. Errors (work): gnuplot is not installed, ended with an error, was killed, or took
/// longer than `limit`.
std::string run_gnuplot(const std::filesystem::path& script, const std::filesystem::path& folder,
                        std::chrono::milliseconds limit);

}  // namespace inkbench
