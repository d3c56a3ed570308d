// SPDX-License-Identifier: MIT
// Ctrl-C and SIGTERM, for commands. The first asks the work to stop; work that has not stopped within a
// second is ended, with temporary files removed. A second signal ends the process at once.
#pragma once

namespace inkbench {

/// From now on. The window hears signals in its own way.
void hear_signals();

}  // namespace inkbench
