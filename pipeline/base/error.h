// SPDX-License-Identifier: MIT
// The one error type. Thrown for what a user, a file, a driver or a shader can cause; our own mistakes are
// asserts. The message says where, what failed and what would be right, in one line a person can act on.
#pragma once

#include <stdexcept>
#include <string>

namespace inkbench {

/// Whose doing an error is; it decides the exit status (`input`: 2, `work`: 1).
enum class ErrorKind { input, work };

class Error : public std::runtime_error {
 public:
  /// `where` is file:line, shader:line or a parameter's key (may be empty); `what` names the failure and the
  /// offending value; `expected` says what would be right (may be empty).
  Error(ErrorKind kind, const std::string& where, const std::string& what, const std::string& expected = "");

  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

/// Bad usage or bad input: `where: what; expected`.
Error input_error(const std::string& where, const std::string& what, const std::string& expected = "");

/// Work that failed although the input was good: a full disk, a driver, a lost file.
Error work_error(const std::string& where, const std::string& what, const std::string& expected = "");

}  // namespace inkbench
