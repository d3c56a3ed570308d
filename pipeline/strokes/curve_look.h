// SPDX-License-Identifier: MIT
// How curves that have no style are shown: in the buffer `curves` and in vector files.
#pragma once

namespace inkbench {

inline constexpr float kCurveWidthPx = 1.5F;
/// Of covered ones.
inline constexpr float kCurveDashPx = 5.0F, kCurveGapPx = 3.0F, kCoveredShare = 0.6F;

}  // namespace inkbench
