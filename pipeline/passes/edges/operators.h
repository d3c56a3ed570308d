// SPDX-License-Identifier: MIT
// Differential operators of 3 x 3 pixels (Saito and Takahashi 1990) on raw buffers, for what is worked out
// beside the GPU. In: an image and a pixel of it. Out: numbers. shaders/lib/operators.glsl is the same.
#pragma once

#include <array>
#include <optional>

#include "pipeline/image/image.h"
#include "pipeline/passes/edges/explanation.h"

namespace inkbench {

bool is_inside_image(const Image& image, int x, int y);

/// |A+2B+C-F-2G-H| + |C+2E+H-A-2D-F|, over 8: 0 on even ground, |dx| + |dy| on a slope, half of the height
/// beside a step. A pixel of the image's border has the value of the nearest one whose neighbours lie inside
/// (our choice: then the border is no edge).
double first_order(const Image& image, int x, int y, int channel = 0);

/// |8X - (A + ... + H)| / 3: 0 on any slope, the change of slope at a crease along a row or column, the
/// height beside a step. The image's border as above.
double second_order(const Image& image, int x, int y, int channel = 0);

/// Largest and smallest of the 3 x 3 values around a pixel that lie inside the image, with their places.
struct RangeAround {
  double largest = 0, smallest = 0;
  Offset largest_at, smallest_at;
};
RangeAround range_of(const std::array<std::optional<float>, 9>& around);

/// The 3 x 3 values around a pixel, row by row from the top left; none outside the image.
std::array<std::optional<float>, 9> values_around(const Image& image, int x, int y, int channel = 0);

}  // namespace inkbench
