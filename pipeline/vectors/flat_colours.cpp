// SPDX-License-Identifier: MIT
#include "pipeline/vectors/flat_colours.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "pipeline/base/stop.h"

namespace inkbench {
namespace {

constexpr int kRounding = 1;  ///< Of 255: how far apart colours may be by rounding.

Rgb shown_colour(const Image& shaded, int x, int y) {
  Rgb colour{};
  for (int channel = 0; channel < 3; ++channel)
    colour[static_cast<size_t>(channel)] =
        static_cast<uint8_t>(std::lround(std::clamp(shaded.at(x, y, channel), 0.0F, 1.0F) * 255.0F));
  return colour;
}

struct CountedColour {
  Rgb colour{};
  int count = 0;
};
using Replacement = std::map<Rgb, Rgb>;  ///< What is drawn of an object instead of what it is shaded with.

bool differ_by_rounding(const Rgb& one, const Rgb& other) {
  for (size_t i = 0; i < 3; ++i) {
    if (std::abs(one[i] - other[i]) > kRounding) return false;
  }
  return true;
}

/// Each colour becomes the most frequent one that rounding might have made of it. Nothing where that leaves
/// too many.
Replacement without_rounding(std::vector<CountedColour> colours) {
  std::stable_sort(colours.begin(), colours.end(), [](const CountedColour& one, const CountedColour& other) {
    return one.count > other.count;
  });
  Replacement replacement;
  std::vector<Rgb> kept;
  for (const CountedColour& counted : colours) {
    const auto near = std::find_if(kept.begin(), kept.end(), [&](const Rgb& colour) {
      return differ_by_rounding(colour, counted.colour);
    });
    if (near == kept.end() && kept.size() == kMostFlatColours) return {};
    replacement[counted.colour] = near == kept.end() ? counted.colour : *near;
    if (near == kept.end()) kept.push_back(counted.colour);
  }
  return replacement;
}

Rgb mean_of(std::vector<CountedColour>::const_iterator begin,
            std::vector<CountedColour>::const_iterator end) {
  std::array<double, 3> sum{};
  double count = 0.0;
  for (auto at = begin; at != end; ++at) {
    for (size_t i = 0; i < 3; ++i) sum[i] += static_cast<double>(at->colour[i]) * at->count;
    count += at->count;
  }
  Rgb mean{};
  for (size_t i = 0; i < 3; ++i) mean[i] = static_cast<uint8_t>(std::lround(sum[i] / count));
  return mean;
}

/// Cuts the box round the colours across its longest side until that is short.
class BoxCutter {
 public:
  explicit BoxCutter(int steps) : side_(255.0 / steps) {}

  void cut(std::vector<CountedColour> colours) {
    const auto [axis, low, high] = longest_side(colours);
    if (high - low <= 1.5 * side_) {
      const Rgb mean = mean_of(colours.begin(), colours.end());
      for (const CountedColour& counted : colours) replacement_[counted.colour] = mean;
      return;
    }
    const int parts = static_cast<int>(std::ceil((high - low) / side_));
    std::vector<std::vector<CountedColour>> boxes(static_cast<size_t>(parts));
    for (const CountedColour& counted : colours) {
      const int box =
          static_cast<int>((counted.colour[axis] - low) / static_cast<double>(high - low + 1) * parts);
      boxes[static_cast<size_t>(box)].push_back(counted);
    }
    for (auto& box : boxes) {
      if (!box.empty()) cut(std::move(box));
    }
  }

  Replacement take() { return std::move(replacement_); }

 private:
  struct Side {
    size_t axis = 0;
    int low = 0, high = 0;
  };
  static Side longest_side(const std::vector<CountedColour>& colours) {
    Side longest;
    for (size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax_element(colours.begin(), colours.end(),
                                                   [=](const CountedColour& one, const CountedColour& other) {
                                                     return one.colour[axis] < other.colour[axis];
                                                   });
      if (high->colour[axis] - low->colour[axis] > longest.high - longest.low || axis == 0)
        longest = {axis, low->colour[axis], high->colour[axis]};
    }
    return longest;
  }

  double side_;
  Replacement replacement_;
};

int object_at(const Image& object_ids, int x, int y) {
  return object_ids.samples.empty() ? 0 : static_cast<int>(std::lround(object_ids.at(x, y)));
}

std::map<int, Replacement> replacements(const Image& shaded, const Image& object_ids, int steps) {
  std::map<int, std::map<Rgb, int>> counts;
  for (int y = 0; y < shaded.height_px; ++y) {
    for (int x = 0; x < shaded.width_px; ++x)
      ++counts[object_at(object_ids, x, y)][shown_colour(shaded, x, y)];
  }
  std::map<int, Replacement> result;
  for (const auto& [object, counted] : counts) {
    stop_if_asked();
    std::vector<CountedColour> colours;
    for (const auto& [colour, count] : counted) colours.push_back({colour, count});
    Replacement& replacement = result[object] = without_rounding(colours);
    if (!replacement.empty()) continue;
    BoxCutter cutter(steps);
    cutter.cut(std::move(colours));
    replacement = cutter.take();
  }
  return result;
}

}  // namespace

FlatPicture flat_colours(const Image& shaded, const Image& object_ids, int steps) {
  const std::map<int, Replacement> drawn = replacements(shaded, object_ids, steps);
  FlatPicture flat{ImageOf<int>(shaded.width_px, shaded.height_px, 1), {}};
  std::map<Rgb, int> numbers;
  for (int y = 0; y < shaded.height_px; ++y) {
    for (int x = 0; x < shaded.width_px; ++x) {
      const Rgb colour = drawn.at(object_at(object_ids, x, y)).at(shown_colour(shaded, x, y));
      const auto [found, is_new] = numbers.emplace(colour, static_cast<int>(flat.colours.size()));
      if (is_new) flat.colours.push_back(colour);
      flat.numbers.at(x, y) = found->second;
    }
  }
  return flat;
}

}  // namespace inkbench
