// SPDX-License-Identifier: MIT
// An X server without a screen, for one test program: started on a free display number and ended with it.
#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

namespace inkbench {

class Display {
 public:
  /// Throws std::runtime_error where Xvfb does not start.
  Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  ~Display();
  /// ":101"
  const std::string& name() const { return name_; }

 private:
  pid_t process_ = -1;
  std::string name_;
};

/// Starts a program without waiting for it; its output goes to `log`. Returns its process.
pid_t start_program(const std::vector<std::string>& command,
                    const std::map<std::string, std::string>& environment, const std::string& folder,
                    const std::string& log);

}  // namespace inkbench
