// SPDX-License-Identifier: MIT
// Letter keys by what is printed on them.
#pragma once

namespace inkbench {

/// The key went down in this frame, by the letter on it, whatever the keyboard's layout.
bool letter_pressed(char letter);

}  // namespace inkbench
