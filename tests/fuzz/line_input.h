// SPDX-License-Identifier: MIT
// A fuzz target's bytes as what the measures take: line maps of odd sizes, polylines, tolerances. In: bytes.
// Out: a number for each question, a zero where the bytes end.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/lines/line_map.h"
#include "pipeline/lines/lines.h"

namespace inkbench {

class Bytes {
 public:
  explicit Bytes(std::span<const uint8_t> bytes) : bytes_(bytes) {}

  int byte();
  /// 0 to `end` - 1; 0 where `end` is 0.
  int below(int end);

 private:
  std::span<const uint8_t> bytes_;
};

/// A tolerance of 0 to 100 px and its square as a whole number, rounded down: known exactly because of how it
/// was made.
struct Tolerance {
  double px = 0;
  int64_t squared = 0;
};
Tolerance read_tolerance(Bytes& bytes);

/// An empty map of 0 x 0 to 140 x 40 px, but at most 1,100 px in all: the plain matching takes the square of
/// that.
LineMap read_size(Bytes& bytes);

/// A map of the size of `like`: nothing, bits, dots, strokes, a pattern, or `like` itself, moved.
LineMap read_map(Bytes& bytes, const LineMap& like);

/// Points in the image, beside it, far away, at infinity and at NaN.
std::vector<Polyline> read_polylines(Bytes& bytes);

}  // namespace inkbench
