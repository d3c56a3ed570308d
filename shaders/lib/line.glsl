// SPDX-License-Identifier: MIT
// The one rule for what a line is in the detector's strength; the lines that are measured and the ink both follow it.
bool is_line(float strength) { return strength > 0.0; }
