// SPDX-License-Identifier: MIT
// A strength map as the thresholds of a precision and recall curve see it. In: strengths, 0 = no line, 1 =
// the strongest. Out: for each pixel how many thresholds it reaches, and the line map at each threshold.
#pragma once

#include "pipeline/image/image.h"
#include "pipeline/lines/line_map.h"

namespace inkbench {

/// A strength map is cut at 1/100, 2/100, ... 99/100: `threshold_of(0)` and up.
inline constexpr int kThresholds = 99;
constexpr double threshold_of(int number) {
  return (number + 1) / 100.0;
}

/// H x W x 1: at how many of the thresholds the pixel is line, 0 to 99. As `LineCut` decides it, values a
/// millionth under a threshold are at it.
using StrengthLevels = ImageOf<uint8_t>;

/// `strengths` has one channel; what is not a number is no line.
StrengthLevels levels_of(const Image& strengths);

/// The line maps from the highest threshold down, each as the one before with some pixels more.
class FallingCut {
 public:
  explicit FallingCut(const StrengthLevels& levels);
  /// Whether threshold `number` has a line pixel that the one above has not.
  bool grows_at(int number) const {
    return end_[number] > (number + 1 == kThresholds ? 0 : end_[number + 1]);
  }
  /// The map at threshold `number`, which must not be above that of the call before.
  const LineMap& at(int number);

 private:
  std::vector<Pixel> pixels_;  ///< The strongest first.
  std::vector<size_t> end_;    ///< Of the pixels that are line at each threshold.
  size_t drawn_ = 0;
  LineMap map_;
};

}  // namespace inkbench
