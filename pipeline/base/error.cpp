// SPDX-License-Identifier: MIT
#include "pipeline/base/error.h"

namespace inkbench {
namespace {

std::string compose(const std::string& where, const std::string& what, const std::string& expected) {
  std::string text = where.empty() ? what : where + ": " + what;
  if (!expected.empty()) text += "; " + expected;
  return text;
}

}  // namespace

Error::Error(ErrorKind kind, const std::string& where, const std::string& what, const std::string& expected)
    : std::runtime_error(compose(where, what, expected)), kind_(kind) {}

Error input_error(const std::string& where, const std::string& what, const std::string& expected) {
  return {ErrorKind::input, where, what, expected};
}

Error work_error(const std::string& where, const std::string& what, const std::string& expected) {
  return {ErrorKind::work, where, what, expected};
}

}  // namespace inkbench
