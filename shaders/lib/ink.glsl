// SPDX-License-Identifier: MIT
// The one rule for how much ink a pixel has and whether it is a line; what is measured and what is drawn both follow it.

// Of the paper's combined edges whatever is not 0 is full ink; else red is the coverage.
float ink_coverage(vec4 drawn, bool is_papers) { return is_papers ? (drawn.r > 0.0 ? 1.0 : 0.0) : drawn.r; }

bool is_line(float coverage) { return coverage >= 0.5; }
