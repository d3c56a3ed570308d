// SPDX-License-Identifier: MIT

// The depth map holds 1 where no model is.
bool is_background(float depth) { return depth >= 1.0; }
