// SPDX-License-Identifier: MIT
#include "pipeline/gl/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

class Expander {
 public:
  explicit Expander(const GeneratedSources& generated) : generated_(generated) {}

  void expand(const std::string& name, const std::string& included_from) {
    if (std::find(open_.begin(), open_.end(), name) != open_.end()) {
      throw input_error(included_from, "\"" + name + "\" includes itself in a circle");
    }
    if (std::find(source_.names.begin(), source_.names.end(), name) != source_.names.end()) return;
    const size_t index = source_.names.size();
    source_.names.push_back(name);
    open_.push_back(name);
    append_lines(name, index, text_of(name, included_from));
    open_.pop_back();
  }

  ShaderSource finish() {
    source_.key = KeyBuilder().add(source_.text).key();
    return std::move(source_);
  }

 private:
  std::string text_of(const std::string& name, const std::string& included_from) {
    if (const auto found = generated_.find(name); found != generated_.end()) return found->second;
    const fs::path path = project_file("shaders/" + name);
    try {
      std::string text = read_file(path);
      source_.files.push_back(path);
      return text;
    } catch (const Error& error) {
      throw input_error(included_from, error.what());
    }
  }

  void append_lines(const std::string& name, size_t index, const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    // `#version` must stay the first line of the whole text.
    if (index > 0) source_.text += fmt::format("#line 1 {}\n", index);
    for (int number = 1; std::getline(lines, line); ++number) {
      const std::string_view trimmed = trim(line);
      if (!trimmed.starts_with("#include")) {
        source_.text += line + "\n";
        continue;
      }
      const size_t open_quote = trimmed.find('"');
      const size_t close_quote = trimmed.rfind('"');
      const std::string where = fmt::format("shaders/{}:{}", name, number);
      if (open_quote == close_quote)
        throw input_error(where, "#include without a name", "write #include \"lib/file.glsl\"");
      expand(std::string(trimmed.substr(open_quote + 1, close_quote - open_quote - 1)), where);
      source_.text += fmt::format("#line {} {}\n", number + 1, index);
    }
  }

  const GeneratedSources& generated_;
  ShaderSource source_;
  std::vector<std::string> open_;
};

}  // namespace

ShaderSource expand_shader(const std::string& name, const GeneratedSources& generated) {
  Expander expander(generated);
  expander.expand(name, "shaders/" + name);
  return expander.finish();
}

std::string find_word(const ShaderSource& source, const std::string& word) {
  static const std::regex kLineDirective(R"(^#line (\d+) (\d+)$)");
  const std::regex whole_word("\\b" + word.substr(0, word.find('[')) +
                              "\\b");  // arrays are reported as "name[0]"
  std::istringstream lines(source.text);
  std::string line;
  size_t file = 0;
  for (size_t number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_match(line, match, kLineDirective)) {
      number = std::stoul(match[1]) - 1;
      file = std::stoul(match[2]);
    } else if (std::regex_search(line.substr(0, line.find("//")), whole_word)) {
      return fmt::format("shaders/{}:{}", source.names[file], number);
    }
  }
  return "";
}

std::string name_log_lines(const std::string& log, const std::vector<std::string>& names) {
  static const std::regex kPlace(R"(^(\d+)(?::(\d+)(?:\(\d+\))?|\((\d+)\))\s*:\s*)");
  std::istringstream lines(log);
  std::string line;
  std::string result;
  while (std::getline(lines, line)) {
    std::smatch match;
    if (std::regex_search(line, match, kPlace) && match[1].length() < 6 &&
        std::stoul(match[1]) < names.size()) {
      const std::string number = match[2].matched ? match[2] : match[3];
      line = "shaders/" + names[std::stoul(match[1])] + ":" + number + ": " + match.suffix().str();
    }
    result += (result.empty() ? "" : "\n") + line;
  }
  return result;
}

}  // namespace inkbench
