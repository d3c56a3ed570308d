// SPDX-License-Identifier: MIT
// The paper's decision worked out beside the GPU: the sum that decided a pixel of `combined_edges`, term by
// term, and which neighbours made it (3.4.4). In: raw buffers and the combine parameters. Out: numbers, and
// the same in words.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "pipeline/image/image.h"
#include "pipeline/passes/edges/edge_class.h"
#include "pipeline/passes/edges/explanation.h"
#include "pipeline/settings/combine_params.h"
#include "pipeline/settings/image_params.h"

namespace inkbench {

/// The pipeline's raw buffers of one image, all of one size. The first two are needed; the others say what
/// made the gradients.
struct EdgeBuffers {
  const Image& depth_edges;          ///< H x W x 1.
  const Image& normal_edges;         ///< H x W x 1.
  const Image* depth = nullptr;      ///< H x W x 1.
  const Image* normal = nullptr;     ///< H x W x 3.
  const Image* object_id = nullptr;  ///< H x W x 1.
  SurfaceMaps surfaces() const { return {depth, normal, object_id}; }
};

/// What made a gradient: of the eight differences that it sums, the one that weighs most.
struct GradientStep {
  Offset to;        ///< From the gradient's own pixel.
  float share = 0;  ///< Of the gradient, 0 to 1.
  float from_depth = 0, to_depth = 0;
  float angle_deg = 0;                 ///< Between the two normals.
  int from_object = 0, to_object = 0;  ///< 0 where there is none or no object buffer was given.
};

/// What lies on both sides of the step from (x, y) to a neighbour inside the image, by the maps there are.
GradientStep step_between_pixels(const SurfaceMaps& maps, int x, int y, Offset to);

/// Of the eight differences of `map` around (x, y) the one that weighs most in the gradient; none where all
/// are 0.
std::optional<GradientStep> largest_step(const SurfaceMaps& maps, const Image& map, int x, int y);

/// One term of the sum: p = min(((gmax - gmin) / k)^2, 1), or 0 where it is switched off.
struct TermWhy {
  bool used = true;
  float k = 0;
  float gmax = 0, gmin = 0;
  Offset max_at, min_at;  ///< Among equal ones the nearest, then the first from the top left.
  float ratio = 0;        ///< (gmax - gmin) / k
  float p = 0;            ///< What it adds to the sum.
  std::optional<GradientStep>
      step;  ///< Of the gradient at `max_at`; needs the term's map and a gradient above 0.
};

struct PixelWhy {
  int x = 0, y = 0;
  TermWhy depth, normal;
  float sum = 0, threshold = 0;
  float edge = 0;  ///< As `combined_edges` stores it: 0, or the sum clamped to 1, in eight bits if so stored.
  bool inked = false;  ///< `edge` is not 0.
};

/// The pixel must be inside the image. Equals the shaders' numbers but for the last digit of a division.
PixelWhy why_pixel(const EdgeBuffers& buffers, const CombineParams& params, int x, int y,
                   Precision precision = Precision::float32);

/// "A line, because the sum of the terms, 1.2, reaches the threshold 0.75."
std::string verdict_text(const PixelWhy& why);

/// What made the term's largest gradient: "normals 62 degrees apart between box and room". `object_names[i]`
/// names object i + 1 (the scene's models).
std::string cause_text(const GradientStep& step, bool is_depth,
                       std::span<const std::string> object_names = {});

}  // namespace inkbench
