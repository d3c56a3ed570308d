// SPDX-License-Identifier: MIT
#include "pipeline/curves/pixel_graph.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

namespace inkbench {
namespace {

constexpr uint32_t kNoPixel = std::numeric_limits<uint32_t>::max();
constexpr int kSeenAheadPx = 6;
constexpr double kLeastCosine = 0.5;  // of a turn of 60 degrees

/// The line pixels of one row, asked for from left to right.
class RowCursor {
 public:
  RowCursor(const std::vector<LinePixel>& pixels, size_t begin, int y) : pixels_(pixels), at_(begin), y_(y) {}
  /// The pixel at `x`, which is not smaller than those asked for before by more than 2.
  uint32_t find(int x) {
    while (at_ > 0 && pixels_[at_ - 1].y == y_ && pixels_[at_ - 1].x >= x) --at_;
    while (at_ < pixels_.size() && (pixels_[at_].y < y_ || (pixels_[at_].y == y_ && pixels_[at_].x < x)))
      ++at_;
    const bool is_there = at_ < pixels_.size() && pixels_[at_].y == y_ && pixels_[at_].x == x;
    return is_there ? static_cast<uint32_t>(at_) : kNoPixel;
  }
  void go_down(int y) { y_ = y; }

 private:
  const std::vector<LinePixel>& pixels_;
  size_t at_;
  int y_;
};

}  // namespace

void PixelGraph::link(uint32_t a, uint32_t b) {
  assert(counts_[a] < kMostLinks && counts_[b] < kMostLinks);
  links_[a][counts_[a]++] = b;
  links_[b][counts_[b]++] = a;
}

PixelGraph::PixelGraph(const LinePixels& lines)
    : links_(lines.pixels.size()), counts_(lines.pixels.size(), 0) {
  const std::vector<LinePixel>& pixels = lines.pixels;
  RowCursor above(pixels, 0, -1), below(pixels, 0, 0);
  for (uint32_t i = 0; i < pixels.size(); ++i) {
    const int x = pixels[i].x, y = pixels[i].y;
    above.go_down(y - 1);
    below.go_down(y + 1);
    const bool is_left = i > 0 && pixels[i - 1].y == y && pixels[i - 1].x == x - 1;
    const bool is_right = i + 1 < pixels.size() && pixels[i + 1].y == y && pixels[i + 1].x == x + 1;
    const bool is_square_above = above.find(x) != kNoPixel && above.find(x + 1) != kNoPixel;
    const uint32_t below_left = below.find(x - 1), straight_below = below.find(x),
                   below_right = below.find(x + 1);
    if (is_right && !is_square_above) link(i, i + 1);
    if (straight_below != kNoPixel) link(i, straight_below);
    if (below_left != kNoPixel && !is_left && straight_below == kNoPixel) link(i, below_left);
    if (below_right != kNoPixel && !is_right && straight_below == kNoPixel) link(i, below_right);
  }
}

namespace {

/// A link seen from the pixel that it leaves: link `slot` of `pixel` is 4 pixel + slot.
using Way = uint32_t;
constexpr Way kNoWay = std::numeric_limits<Way>::max();

class PixelChainer {
 public:
  PixelChainer(const LinePixels& lines, const PixelGraph& graph)
      : lines_(lines),
        graph_(graph),
        partner_(graph.size() * PixelGraph::kMostLinks, kNoWay),
        done_(graph.size() * PixelGraph::kMostLinks, 0) {}

  std::vector<PixelChain> chains() {
    for (uint32_t pixel = 0; pixel < graph_.size(); ++pixel) pair_ways(pixel);
    std::vector<PixelChain> chains;
    for (uint32_t pixel = 0; pixel < graph_.size(); ++pixel) {
      if (graph_.links_of(pixel).empty()) chains.push_back({{pixel}});
      for_each_way(pixel, [&](Way way) {
        if (partner_[way] == kNoWay && done_[way] == 0) chains.push_back({walk(way)});
      });
    }
    for (uint32_t pixel = 0; pixel < graph_.size(); ++pixel) {
      for_each_way(pixel, [&](Way way) {
        if (done_[way] == 0) chains.push_back({walk(way), true});
      });
    }
    return chains;
  }

 private:
  template <class Use>
  void for_each_way(uint32_t pixel, const Use& use) const {
    const auto count = static_cast<Way>(graph_.links_of(pixel).size());
    for (Way slot = 0; slot < count; ++slot) use(first_way(pixel) + slot);
  }
  static Way first_way(uint32_t pixel) { return pixel * static_cast<Way>(PixelGraph::kMostLinks); }
  static uint32_t from(Way way) { return way / static_cast<Way>(PixelGraph::kMostLinks); }
  uint32_t to(Way way) const { return graph_.links_of(from(way))[way % PixelGraph::kMostLinks]; }
  /// The same link from its other pixel.
  Way back(Way way) const {
    const std::span<const uint32_t> links = graph_.links_of(to(way));
    const auto slot = std::find(links.begin(), links.end(), from(way)) - links.begin();
    return first_way(to(way)) + static_cast<Way>(slot);
  }

  /// Where a line leads that leaves a pixel.
  glm::vec2 direction(Way way) const {
    const glm::vec2 start = lines_.pixels[from(way)].point();
    uint32_t before = from(way), at = to(way);
    for (int step = 1; step < kSeenAheadPx && !graph_.is_node(at); ++step) {
      const std::span<const uint32_t> links = graph_.links_of(at);
      const uint32_t next = links[0] == before ? links[1] : links[0];
      before = at;
      at = next;
    }
    const glm::vec2 along = lines_.pixels[at].point() - start;
    const float length = glm::length(along);
    return length > 0.0F ? along / length : glm::vec2(0.0F);
  }

  void join(Way a, Way b) {
    partner_[a] = b;
    partner_[b] = a;
  }

  void pair_ways(uint32_t pixel) {
    if (!graph_.is_node(pixel)) join(first_way(pixel), first_way(pixel) + 1);
    if (graph_.links_of(pixel).size() < 3) return;
    std::vector<std::tuple<double, Way, Way>> pairs;
    for_each_way(pixel, [&](Way a) {
      for_each_way(pixel, [&](Way b) {
        const double cosine = -glm::dot(direction(a), direction(b));
        if (a < b && cosine >= kLeastCosine) pairs.emplace_back(-cosine, a, b);
      });
    });
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [bend, a, b] : pairs) {
      if (partner_[a] == kNoWay && partner_[b] == kNoWay) join(a, b);
    }
  }

  /// Along a link and on, until a chain ends or is back at the start.
  std::vector<uint32_t> walk(Way way) {
    std::vector<uint32_t> chain{from(way)};
    while (way != kNoWay && done_[way] == 0) {
      const Way reverse = back(way);
      done_[way] = done_[reverse] = 1;
      chain.push_back(to(way));
      way = partner_[reverse];
    }
    return chain;
  }

  const LinePixels& lines_;
  const PixelGraph& graph_;
  std::vector<Way> partner_;
  std::vector<uint8_t> done_;
};

}  // namespace

std::vector<PixelChain> chain_pixels(const LinePixels& lines, const PixelGraph& graph) {
  return PixelChainer(lines, graph).chains();
}

}  // namespace inkbench
