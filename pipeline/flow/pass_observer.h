// SPDX-License-Identifier: MIT
// Who is told of each pass that runs: the window's timings. Knows nothing of passes but their names.
#pragma once

#include <string_view>

namespace inkbench {

class PassObserver {
 public:
  virtual ~PassObserver() = default;
  /// Before and after the OpenGL commands of a pass that runs; one that is reused is not told. Passes do not
  /// lie within each other.
  virtual void begin_pass(std::string_view name) = 0;
  virtual void end_pass() = 0;
};

/// Tells an observer, if there is one, for as long as it lives.
class PassScope {
 public:
  PassScope(PassObserver* observer, std::string_view name) : observer_(observer) {
    if (observer_ != nullptr) observer_->begin_pass(name);
  }
  PassScope(const PassScope&) = delete;
  PassScope& operator=(const PassScope&) = delete;
  ~PassScope() {
    if (observer_ != nullptr) observer_->end_pass();
  }

 private:
  PassObserver* observer_;
};

}  // namespace inkbench
