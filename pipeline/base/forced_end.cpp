// SPDX-License-Identifier: MIT
#include "pipeline/base/forced_end.h"

#include <iterator>
#include <mutex>
#include <utility>

namespace inkbench {
namespace {

/// Recursive: an action may write a file, which has one of its own. Never destroyed: the process may end with
/// threads at work.
struct ForcedEnd {
  std::recursive_mutex mutex;
  std::list<std::function<void()>> actions;
};

ForcedEnd& forced_end() {
  static ForcedEnd& end = *new ForcedEnd;
  return end;
}

}  // namespace

ForcedEndAction::ForcedEndAction(std::function<void()> action) {
  const std::lock_guard lock(forced_end().mutex);
  place_ = forced_end().actions.insert(forced_end().actions.end(), std::move(action));
}

ForcedEndAction::~ForcedEndAction() {
  const std::lock_guard lock(forced_end().mutex);
  forced_end().actions.erase(place_);
}

void do_forced_end_actions() {
  forced_end().mutex.lock();  // for ever
  for (auto action = forced_end().actions.rbegin(); action != forced_end().actions.rend(); ++action) {
    try {
      (*action)();
    } catch (...) {
    }
  }
}

}  // namespace inkbench
