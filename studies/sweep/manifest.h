// SPDX-License-Identifier: MIT
// manifest.json: what was run, with what, and when.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/gl/context.h"
#include "studies/sweep/run_study.h"

namespace inkbench {

/// What the study needs to run again, by name: inkbench, renderer, OpenGL, libraries.
std::vector<std::pair<std::string, std::string>> study_versions();

/// The command that runs it: "inkbench study studies/k_sweep.toml --set ink.width=2", from the project's
/// folder where the spec lies in it.
std::string study_command(const StudySpec& spec);
/// The same, or what the extras say.
std::string made_by(const StudySpec& spec, const ReportExtras& extras);
/// "inkbench WORD PATH --set ...", so that it works from the project's folder.
std::string spec_command(const std::string& word, const std::filesystem::path& path,
                         const std::vector<std::string>& assignments);

/// Writes `folder/manifest.json`, with the hashes of what else lies in the folder besides cells once `state`
/// is not "running". `state` is "running", "finished" or "stopped"; times stand under "times" alone, so that
/// all else is the same for the same study.
void write_manifest(const std::filesystem::path& folder, const StudySpec& spec, const std::string& command,
                    const StudyResult& result, const std::string& state);

/// Makes the manifest's state "stopped" in its place, which needs no room on a disk and nothing but the
/// folder. What cannot be done stays undone.
void mark_stopped(const std::filesystem::path& folder) noexcept;

}  // namespace inkbench
