// The values behind one pixel, read from the GPU. In: settings and a pixel. Out: the sum that decided it, and
// the gradients around it that the sum is made of.
#pragma once

#include <array>
#include <optional>

#include "app/workbench/pixel_why.h"
#include "pipeline/pipeline.h"

namespace inkbench {

/// 3 x 3, row by row from the top left; none outside the image.
using Neighbourhood = std::array<std::optional<float>, 9>;

struct ProbedPixel {
  PixelWhy why;
  Neighbourhood depth_edges, normal_edges;
  float drawn = 0.0F;  ///< What the GPU stored in `combined_edges`.
};

class PixelProbe {
 public:
  /// The pixel must be inside the image. Reads a few pixels of the buffers, and nothing where neither the
  /// buffers nor the pixel changed. Errors: as `Frame::raw_part`.
  const ProbedPixel& probe(const Frame& frame, int x, int y);
  /// The last one.
  const ProbedPixel& last() const { return probed_; }

 private:
  Key key_;
  int x_ = -1, y_ = -1;
  ProbedPixel probed_;
};

}  // namespace inkbench
