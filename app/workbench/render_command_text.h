// SPDX-License-Identifier: MIT
// The settings as a command line: `inkbench render ...` that draws the same.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/buffers.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

struct RenderCommand {
  std::string text;                      ///< One line, quoted for a POSIX shell.
  std::vector<std::string> assignments;  ///< What its `--set`s say, unquoted.
  std::filesystem::path scene;           ///< What they are set on.
};

/// What a shell calls this very program by: `inkbench` where its search path leads here, else its whole path.
std::string program_word();

/// A parameter's value as `--set` takes it, unquoted.
std::string assignment_text(const Field& field, const std::string& key, const Value& value);

/// `program` is as the shell needs it. `scene` is the file that the settings started from, or empty; one that
/// is the paper's is not written. Errors (input): no scene file has these models and lights: the settings
/// must be saved as one first.
RenderCommand render_command(const Settings& settings, const std::filesystem::path& scene,
                             const std::vector<BufferName>& buffers = {BufferName::final},
                             const std::filesystem::path& out = "out/render",
                             const std::string& program = "inkbench");

}  // namespace inkbench
