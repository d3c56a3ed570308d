// SPDX-License-Identifier: MIT
// What every spec begins with, a study's and a search's: the scene, the size of its images, [set]. In: the
// document. Out: the settings that all its drawings start from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/params/toml_document.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// `path`: the spec's, for errors and relative paths; `assignments`: `--set` texts on top. The paper's scene
/// where none is named. Errors (input): file:line of what is wrong, a scene that is not there.
Settings read_base(const TomlNode& document, const std::filesystem::path& path,
                   const std::vector<std::string>& assignments);

}  // namespace inkbench
