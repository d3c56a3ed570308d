// SPDX-License-Identifier: MIT
// code_hash OUT ROOT NAME FILE... [-- NAME FILE...]: writes a C++ file that defines each NAME as the hash of
// its files' code, which lie under ROOT. Run by the build. The file keeps its time where nothing changed, so
// that nothing is compiled again.
#include <cstdio>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "pipeline/base/key.h"
#include "scripts/code_hash/code_text.h"

namespace inkbench {
namespace {

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  if (!(content << file.rdbuf())) throw std::runtime_error(path + " cannot be read");
  return content.str();
}

std::string definitions(const std::string& root, const std::vector<std::string>& words) {
  std::string text =
      "#include \"studies/sweep/result_origin.h\"\n\nnamespace inkbench {\n\n"
      "// Made by scripts/code_hash.\n";
  for (size_t i = 0; i < words.size(); ++i) {
    const std::string name = words[i];
    KeyBuilder builder;
    for (++i; i < words.size() && words[i] != "--"; ++i)
      builder.add(words[i]).add(code_text(content_of(root + "/" + words[i])));
    text += "const char* const " + name + " = \"" + builder.key().text() + "\";\n";
  }
  return text + "\n}  // namespace inkbench\n";
}

void write_if_other(const std::string& path, const std::string& text) {
  std::ifstream before(path, std::ios::binary);
  std::ostringstream old;
  if (before && (old << before.rdbuf()) && old.str() == text) return;
  std::ofstream file(path, std::ios::binary);
  if (!(file << text << std::flush)) throw std::runtime_error(path + " cannot be written");
}

}  // namespace
}  // namespace inkbench

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() < 3) throw std::runtime_error("code_hash OUT ROOT NAME FILE... [-- NAME FILE...]");
    inkbench::write_if_other(words[0], inkbench::definitions(words[1], {words.begin() + 2, words.end()}));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "code_hash: error: %s\n", error.what());
    return 1;
  }
}
