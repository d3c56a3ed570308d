// SPDX-License-Identifier: MIT
// The passes of a frame by the renderer's own clock, and which shader files were drawn with.
#pragma once

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "pipeline/base/files.h"
#include "pipeline/flow/pass_observer.h"

namespace inkbench {

/// The shader files of all programs that were in use after something was drawn.
class DrawnShaders {
 public:
  void note() {
    GLint program = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    if (program == 0) return;
    std::array<char, 256> label{};
    glGetObjectLabel(GL_PROGRAM, static_cast<GLuint>(program), static_cast<GLsizei>(label.size()), nullptr,
                     label.data());
    const std::string names = label.data();  // "VERTEX + FRAGMENT"
    const size_t plus = names.find(" + ");
    if (plus == std::string::npos) return;
    names_.insert(names.substr(0, plus));
    names_.insert(names.substr(plus + 3));
  }
  /// Of shaders/, without its parts.
  std::vector<std::string> missing() const {
    std::vector<std::string> missing;
    for (const std::filesystem::directory_entry& file :
         std::filesystem::directory_iterator(project_file("shaders"))) {
      const std::string name = file.path().filename().string();
      if (file.is_regular_file() && !names_.contains(name)) missing.push_back(name);
    }
    std::ranges::sort(missing);
    return missing;
  }
  size_t count() const { return names_.size(); }

 private:
  std::set<std::string> names_;
};

/// Milliseconds of each pass of a frame by the renderer's clock.
class PassClock final : public PassObserver {
 public:
  explicit PassClock(DrawnShaders& drawn) : drawn_(drawn) {}
  void begin_pass(std::string_view name) override {
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_TIME_ELAPSED, query);
    running_.emplace_back(name, query);
  }
  void end_pass() override {
    glEndQuery(GL_TIME_ELAPSED);
    drawn_.note();
  }
  /// Waits for the renderer.
  std::map<std::string, double> take() {
    std::map<std::string, double> ms;
    for (const auto& [name, query] : running_) {
      GLuint64 ns = 0;
      glGetQueryObjectui64v(query, GL_QUERY_RESULT, &ns);
      glDeleteQueries(1, &query);
      ms[name] += static_cast<double>(ns) * 1e-6;
    }
    running_.clear();
    return ms;
  }

 private:
  DrawnShaders& drawn_;
  std::vector<std::pair<std::string, GLuint>> running_;
};

}  // namespace inkbench
