// manifest.json: what was run, with what, and when.
#pragma once

#include <filesystem>
#include <string>

#include "pipeline/gl/context.h"
#include "studies/sweep/run_study.h"

namespace inkbench {

/// Writes `folder/manifest.json`. `state` is "running", "finished" or "stopped"; times stand under "times"
/// alone, so that all else is the same for the same study.
void write_manifest(const std::filesystem::path& folder, const StudySpec& spec, const StudyResult& result,
                    const std::string& state);

}  // namespace inkbench
