// SPDX-License-Identifier: MIT
// A copy of the project's files in a temporary folder that the program reads instead, to edit them in
// tests.
#pragma once

#include "pipeline/base/files.h"
#include "tests/gl/checks.h"

namespace inkbench {

class ShaderFolder {
 public:
  ShaderFolder() {
    fs::copy(project_file("shaders"), folder_.path() / "shaders", fs::copy_options::recursive);
    fs::create_directory(folder_.path() / "studies");
    fs::copy(project_file("data"), folder_.path() / "data",
             fs::copy_options::recursive);  // a project's root has it
    fs::copy(project_file("studies/report"), folder_.path() / "studies/report", fs::copy_options::recursive);
    root_.emplace("INKBENCH_ROOT", folder_.path().string());
  }
  void write(const std::string& name, const std::string& text) { folder_.write("shaders/" + name, text); }
  std::string read(const std::string& name) const { return read_file(folder_.path() / "shaders" / name); }
  /// Replaces one piece of text that the file must hold.
  void edit(const std::string& name, const std::string& before, const std::string& after) {
    std::string text = read(name);
    const size_t place = text.find(before);
    ASSERT_NE(place, std::string::npos) << name << " no longer holds: " << before;
    write(name, text.replace(place, before.size(), after));
  }

 private:
  TempFolder folder_;
  std::optional<ScopedVariable> root_;
};

}  // namespace inkbench
