// SPDX-License-Identifier: MIT
#include "pipeline/vectors/border_network.h"

#include <algorithm>
#include <array>
#include <limits>

namespace inkbench {
namespace {

constexpr size_t kNoBorder = std::numeric_limits<size_t>::max();
constexpr int kOutside = -1;

/// Right, down, left, up: the next one is a turn to the right.
constexpr std::array<glm::ivec2, 4> kWays{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// What lies round the corners of pixels.
class Corners {
 public:
  explicit Corners(const ImageOf<int>& regions) : regions_(regions) {}

  /// The region to the right of the step from a corner that way.
  int right_of(const glm::ivec2& corner, int way) const {
    // Of the four pixels round the corner: that below and right, then clockwise.
    constexpr std::array<glm::ivec2, 4> kPixels{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
    return region(corner + kPixels[static_cast<size_t>(way)]);
  }
  int left_of(const glm::ivec2& corner, int way) const { return right_of(corner, (way + 3) % 4); }

  /// Whether a border runs that way.
  bool is_border(const glm::ivec2& corner, int way) const {
    return right_of(corner, way) != left_of(corner, way);
  }

  /// How many borders meet there.
  int meeting(const glm::ivec2& corner) const {
    int count = 0;
    for (int way = 0; way < 4; ++way) count += is_border(corner, way) ? 1 : 0;
    return count;
  }

 private:
  int region(const glm::ivec2& pixel) const {
    const bool is_inside =
        pixel.x >= 0 && pixel.y >= 0 && pixel.x < regions_.width_px && pixel.y < regions_.height_px;
    return is_inside ? regions_.at(pixel.x, pixel.y) : kOutside;
  }

  const ImageOf<int>& regions_;
};

class NetworkMaker {
 public:
  explicit NetworkMaker(const ImageOf<int>& regions)
      : corners_(regions),
        size_(regions.width_px + 1, regions.height_px + 1),
        border_at_(regions.width_px + 1, regions.height_px + 1, 2, kNoBorder) {}

  BorderNetwork make(size_t region_count) {
    for (const bool from_meetings : {true, false}) {
      for (int y = 0; y < size_.y; ++y) {
        for (int x = 0; x < size_.x; ++x) {
          if (from_meetings == (corners_.meeting({x, y}) > 2)) follow_all({x, y});
        }
      }
    }
    network_.size = size_ - 1;
    network_.rings.resize(region_count);
    used_.resize(network_.borders.size(), {false, false});
    for (size_t border = 0; border < network_.borders.size(); ++border) {
      add_ring({border, false});
      add_ring({border, true});
    }
    return std::move(network_);
  }

 private:
  /// The border that the step from a corner that way is a part of.
  size_t& border_at(const glm::ivec2& corner, int way) {
    const glm::ivec2 from = way < 2 ? corner : corner + kWays[static_cast<size_t>(way)];
    return border_at_.at(from.x, from.y, way % 2);
  }

  void follow_all(const glm::ivec2& corner) {
    for (int way = 0; way < 4; ++way) {
      if (corners_.is_border(corner, way) && border_at(corner, way) == kNoBorder) follow(corner, way);
    }
  }

  /// On to where borders meet, or back to where it began.
  void follow(const glm::ivec2& first, int way) {
    Border border{{first}, corners_.meeting(first) == 2};
    do {
      const glm::ivec2 at = border.corners.back() + kWays[static_cast<size_t>(way)];
      border_at(border.corners.back(), way) = network_.borders.size();
      border.corners.push_back(at);
      if (corners_.meeting(at) > 2) break;
      for (const int turn : {0, 1, 3}) {
        if (!corners_.is_border(at, (way + turn) % 4)) continue;
        way = (way + turn) % 4;
        break;
      }
    } while (border.corners.back() != first);
    network_.borders.push_back(std::move(border));
  }

  static int way_of(const glm::ivec2& step) {
    return static_cast<int>(std::find(kWays.begin(), kWays.end(), step) - kWays.begin());
  }

  /// Corners along a border as it is used: the first two, the last two.
  std::array<glm::ivec2, 4> ends(const BorderUse& use) const {
    const auto& corners = network_.borders[use.border].corners;
    const size_t last = corners.size() - 1;
    if (use.is_backwards) return {corners[last], corners[last - 1], corners[1], corners[0]};
    return {corners[0], corners[1], corners[last - 1], corners[last]};
  }

  int region_of(const BorderUse& use) const {
    const auto [first, second, before_last, last] = ends(use);
    return corners_.right_of(first, way_of(second - first));
  }

  /// What goes on round the same region: to the right where that is not the region, which is connected across
  /// sides alone; else straight; else left.
  BorderUse next_use(const BorderUse& use) {
    const auto [first, second, before_last, last] = ends(use);
    const int way = way_of(last - before_last), region = region_of(use);
    int turned = (way + 1) % 4;
    while (corners_.right_of(last, turned) != region || corners_.left_of(last, turned) == region)
      turned = (turned + 3) % 4;
    const size_t border = border_at(last, turned);
    const auto& corners = network_.borders[border].corners;
    const bool is_forwards = corners[0] == last && way_of(corners[1] - corners[0]) == turned;
    return {border, !is_forwards};
  }

  void add_ring(const BorderUse& first) {
    const int region = region_of(first);
    if (region == kOutside || used_[first.border][first.is_backwards ? 1 : 0]) return;
    BorderRing& ring = network_.rings[static_cast<size_t>(region)].emplace_back();
    BorderUse use = first;
    do {
      ring.push_back(use);
      used_[use.border][use.is_backwards ? 1 : 0] = true;
      if (!network_.borders[use.border].is_round) use = next_use(use);
    } while (!(use == first));
  }

  Corners corners_;
  glm::ivec2 size_;
  ImageOf<size_t> border_at_;  ///< For each corner the border of the step to the right and of that down.
  BorderNetwork network_;
  std::vector<std::array<bool, 2>> used_;
};

}  // namespace

BorderNetwork border_network(const ImageOf<int>& regions) {
  const auto last = std::max_element(regions.samples.begin(), regions.samples.end());
  return NetworkMaker(regions).make(last == regions.samples.end() ? 0 : static_cast<size_t>(*last) + 1);
}

}  // namespace inkbench
