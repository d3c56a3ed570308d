// SPDX-License-Identifier: MIT
// SIGTERM, SIGINT and SIGHUP ask the window to end as its own cross does, so that the session is kept. A
// second one of the same kind ends the program at once.
#pragma once

namespace inkbench {

/// From now on.
void watch_end_signals();

/// Whether one has come.
bool end_is_asked();

}  // namespace inkbench
