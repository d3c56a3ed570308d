// Doing what a person asked for where it may fail: the reason is shown, and nothing else happens.
#pragma once

#include "app/window/workbench.h"
#include "pipeline/base/error.h"

namespace inkbench {

/// Returns whether it worked.
template <class Action>
bool attempt(Workbench& bench, const Action& action) {
  try {
    action();
    bench.dismiss(ProblemKind::input);
    return true;
  } catch (const Error& error) {
    bench.set_problem(ProblemKind::input, error.what());
    return false;
  }
}

}  // namespace inkbench
