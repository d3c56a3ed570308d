// SPDX-License-Identifier: MIT
// Doing what a person asked for where it may fail: the reason is shown, and nothing else happens.
#pragma once

#include "app/workbench/problems.h"
#include "pipeline/base/error.h"

namespace inkbench {

/// Returns whether it worked.
template <class Action>
bool attempt(Problems& problems, const Action& action) {
  try {
    action();
    problems.dismiss(ProblemKind::input);
    return true;
  } catch (const Error& error) {
    problems.set(ProblemKind::input, error.what());
    return false;
  }
}

}  // namespace inkbench
