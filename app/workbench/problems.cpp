// SPDX-License-Identifier: MIT
#include "app/workbench/problems.h"

namespace inkbench {

void Problems::set(ProblemKind kind, const std::string& text) {
  const auto found = problems_.find(kind);
  if (found == problems_.end() || found->second != text) tell(Severity::error, text);
  problems_[kind] = text;
}

}  // namespace inkbench
