// SPDX-License-Identifier: MIT
#include "pipeline/vectors/regions.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "pipeline/base/stop.h"

namespace inkbench {
namespace {

using PixelAt = std::pair<int, int>;

/// Calls `visit(x, y)` for the pixels beside one.
template <class Visit>
void visit_beside(const ImageOf<int>& image, const PixelAt& at, const Visit& visit) {
  constexpr std::array<PixelAt, 4> kSteps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  for (const auto& [dx, dy] : kSteps) {
    const int x = at.first + dx, y = at.second + dy;
    if (x >= 0 && x < image.width_px && y >= 0 && y < image.height_px) visit(x, y);
  }
}

/// The pixels of the region of which one is given; `region` of them becomes `number`.
std::vector<PixelAt> flood(const ImageOf<int>& numbers, const PixelAt& from, int number,
                           ImageOf<int>& region) {
  std::vector<PixelAt> pixels{from};
  region.at(from.first, from.second) = number;
  for (size_t i = 0; i < pixels.size(); ++i) {
    const PixelAt at = pixels[i];
    visit_beside(numbers, at, [&](int x, int y) {
      if (region.at(x, y) >= 0 || numbers.at(x, y) != numbers.at(at.first, at.second)) return;
      region.at(x, y) = number;
      pixels.emplace_back(x, y);
    });
  }
  return pixels;
}

/// The regions smaller than `least`, the smallest first.
std::vector<std::vector<PixelAt>> small_regions(const ImageOf<int>& numbers, int least) {
  std::vector<std::vector<PixelAt>> small;
  ImageOf<int> region(numbers.width_px, numbers.height_px, 1, -1);
  for (int y = 0; y < numbers.height_px; ++y) {
    for (int x = 0; x < numbers.width_px; ++x) {
      if (region.at(x, y) >= 0) continue;
      std::vector<PixelAt> pixels = flood(numbers, {x, y}, 0, region);
      if (static_cast<int>(pixels.size()) < least) small.push_back(std::move(pixels));
    }
  }
  std::stable_sort(small.begin(), small.end(),
                   [](const auto& one, const auto& other) { return one.size() < other.size(); });
  return small;
}

/// Returns whether it was done: not where there is no neighbour, or a neighbour has taken the region's number
/// meanwhile, so that the pixels are a part of it.
bool merge(const std::vector<PixelAt>& pixels, ImageOf<int>& numbers) {
  const int own = numbers.at(pixels[0].first, pixels[0].second);
  bool is_part = false;
  std::map<int, int> shared;
  for (const PixelAt& at : pixels) {
    visit_beside(numbers, at, [&](int x, int y) {
      if (numbers.at(x, y) != own) {
        ++shared[numbers.at(x, y)];
      } else {
        is_part = is_part || std::find(pixels.begin(), pixels.end(), PixelAt{x, y}) == pixels.end();
      }
    });
  }
  if (is_part || shared.empty()) return false;
  const auto longest = std::max_element(shared.begin(), shared.end(), [](const auto& one, const auto& other) {
    return one.second < other.second;
  });
  for (const auto& [x, y] : pixels) numbers.at(x, y) = longest->first;
  return true;
}

}  // namespace

Regions find_regions(const ImageOf<int>& numbers) {
  Regions found{ImageOf<int>(numbers.width_px, numbers.height_px, 1, -1), {}, {}};
  for (int y = 0; y < numbers.height_px; ++y) {
    for (int x = 0; x < numbers.width_px; ++x) {
      if (found.region.at(x, y) >= 0) continue;
      const int number = static_cast<int>(found.numbers.size());
      found.areas.push_back(static_cast<int>(flood(numbers, {x, y}, number, found.region).size()));
      found.numbers.push_back(numbers.at(x, y));
    }
  }
  return found;
}

Regions without_small_regions(ImageOf<int> numbers, int least) {
  for (bool is_merged = true; is_merged;) {
    stop_if_asked();
    is_merged = false;
    for (const std::vector<PixelAt>& pixels : small_regions(numbers, least))
      is_merged = merge(pixels, numbers) || is_merged;
  }
  return find_regions(numbers);
}

}  // namespace inkbench
