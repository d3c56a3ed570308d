// SPDX-License-Identifier: MIT
// Line pixels joined to chains. In: pixels of thin lines. Out: which of them follow each other.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/curves/line_pixels.h"

namespace inkbench {

/// Neighbours of eight are linked, but for diagonal ones that have a line pixel beside both, and the lower
/// two of a square of four: so the links have a ring for each hole of the lines and none besides.
class PixelGraph {
 public:
  static constexpr size_t kMostLinks = 4;  ///< Of a pixel: a diagonal link needs both of its sides empty.

  explicit PixelGraph(const LinePixels& lines);

  size_t size() const { return links_.size(); }
  /// The linked pixels by index.
  std::span<const uint32_t> links_of(uint32_t pixel) const { return {links_[pixel].data(), counts_[pixel]}; }
  /// Does a line end or meet others there?
  bool is_node(uint32_t pixel) const { return counts_[pixel] != 2; }

 private:
  void link(uint32_t a, uint32_t b);

  std::vector<std::array<uint32_t, kMostLinks>> links_;
  std::vector<uint8_t> counts_;
};

struct PixelChain {
  std::vector<uint32_t> pixels;  ///< A ring repeats its first one.
  bool is_ring = false;          ///< It goes on where it started; a chain may also end there with a corner.
};

/// Chains that use each link once, and each pixel without links as a chain of its own. Where lines meet the
/// straightest pair goes on, then the straightest of the rest, as long as the turn is at most 60 degrees as
/// seen over six pixels. The order depends on the pixels alone.
std::vector<PixelChain> chain_pixels(const LinePixels& lines, const PixelGraph& graph);

}  // namespace inkbench
