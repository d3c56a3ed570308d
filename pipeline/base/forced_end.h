// SPDX-License-Identifier: MIT
// What must still be done where the process ends itself in the middle of its work, since the work did not
// stop by itself in time: temporary files removed, a manifest that says so.
#pragma once

#include <functional>
#include <list>

namespace inkbench {

/// While it lives, `action` is done at a forced end. It runs on another thread than the work's.
class ForcedEndAction {
 public:
  explicit ForcedEndAction(std::function<void()> action);
  ForcedEndAction(const ForcedEndAction&) = delete;
  ForcedEndAction& operator=(const ForcedEndAction&) = delete;
  ~ForcedEndAction();

 private:
  std::list<std::function<void()>>::iterator place_;
};

/// Does all of them, the youngest first, and lets no object above be made or destroyed from now on by another
/// thread: the caller ends the process. What they throw is lost.
void do_forced_end_actions();

}  // namespace inkbench
