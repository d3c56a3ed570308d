// SPDX-License-Identifier: MIT
// What every window adds to and the session file holds once: recent files and camera bookmarks. A window that
// closes keeps what another one wrote since it started.
#pragma once

#include "app/workbench/session.h"

namespace inkbench {

/// `ours` with what `theirs` added to `base` and, of the bookmarks, without what it removed. A digit that is
/// taken stays with ours; what is too much goes.
void merge_lists(const Session& base, const Session& theirs, Session& ours);

}  // namespace inkbench
