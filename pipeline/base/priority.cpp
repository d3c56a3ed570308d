// SPDX-License-Identifier: MIT
#include "pipeline/base/priority.h"

#include <sys/resource.h>
#include <unistd.h>

namespace inkbench {

void step_back_for_drawing() {
  constexpr int kNice = 10;
  // On Linux each thread has a priority of its own.
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
}

}  // namespace inkbench
