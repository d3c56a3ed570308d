// SPDX-License-Identifier: MIT
// Shader files with `#include "..."`, expanded to one text whose errors name the file and line that a person
// edits.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/base/key.h"

namespace inkbench {

/// Texts that stand for files under "generated/": uniform blocks from the parameters' descriptions.
using GeneratedSources = std::map<std::string, std::string>;

struct ShaderSource {
  std::string text;                          ///< With `#line LINE INDEX` before each part.
  std::vector<std::string> names;            ///< File of each index.
  std::vector<std::filesystem::path> files;  ///< The real ones among them, to watch.
  Key key;                                   ///< Of the text.
};

/// Reads shaders/`name` and what it includes, each file once. Errors (input): missing file, circular include,
/// with the including file and line.
ShaderSource expand_shader(const std::string& name, const GeneratedSources& generated);

/// "shaders/FILE:LINE" where the word first stands in the expanded text, comments not counted; "" where it
/// does not.
std::string find_word(const ShaderSource& source, const std::string& word);

/// A compiler's log with the index at the start of each line replaced by its file's name
/// ("2:14(3): error" and "2(14) : error" both become "lib/edges.glsl:14: error").
std::string name_log_lines(const std::string& log, const std::vector<std::string>& names);

}  // namespace inkbench
