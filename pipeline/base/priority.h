// SPDX-License-Identifier: MIT
// Which threads step back when the processor is short: what is drawn now comes before what works beside it.
#pragma once

namespace inkbench {

/// Lowers the calling thread's priority (nice 10) for as long as it lives: it works in the time that drawing
/// leaves. No error; where the system refuses, nothing changes.
void step_back_for_drawing();

}  // namespace inkbench
