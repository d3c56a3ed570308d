// SPDX-License-Identifier: MIT
// Which parts of a projected line are seen. In: the line and the depth buffer. Out: the visible pieces.
#pragma once

#include <vector>

#include "pipeline/image/image.h"
#include "pipeline/lines/projection.h"

namespace inkbench {

inline constexpr double kSampleStepPx = 0.5;
inline constexpr double kShortestPiecePx = 3.0;
inline constexpr double kDepthSlack = 0.001;

/// Points every `kSampleStepPx` of a line's length in the image, from its start on, and its end.
struct LineSample {
  double along_px = 0.0;  ///< Distance from the line's start.
  glm::dvec3 point{0.0};
};
std::vector<LineSample> sample_line(const ProjectedLine& line);

class DepthTest {
 public:
  /// `depth`: the raw depth buffer of that camera, H x W x 1, distance along the view axis / far, row 0 on
  /// top; it must outlive the test.
  DepthTest(const Image& depth, const CameraParams& camera) : depth_(depth), camera_(camera) {}

  /// Whether w = 1 / z is at least (1 - 0.001) times the smallest w in the 3 x 3 pixels around the point, as
  /// far as they lie in the image; in orthographic views, whether z is at most the largest z there and 0.001
  /// of the view's height.
  bool is_visible(const glm::dvec3& point) const;

 private:
  const Image& depth_;
  CameraParams camera_;
};

/// Runs of visible samples, each from its first to its last sample, if that is `kShortestPiecePx` or longer.
/// A closed line that is visible all around stays closed; a piece may run across its start.
std::vector<ProjectedLine> visible_pieces(const ProjectedLine& line, const DepthTest& test);

}  // namespace inkbench
