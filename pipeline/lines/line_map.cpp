// SPDX-License-Identifier: MIT
#include "pipeline/lines/line_map.h"

namespace inkbench {

int64_t LineMap::count() const {
  int64_t total = 0;
  for (const uint64_t word : words_) total += word == 0 ? 0 : std::popcount(word);
  return total;
}

std::vector<Pixel> pixels_of(const LineMap& map) {
  std::vector<Pixel> pixels;
  pixels.reserve(map.count());
  for_each_pixel(map, [&](int x, int y) { pixels.push_back({x, y}); });
  return pixels;
}

LineMap without_border(const LineMap& map, int border_px) {
  LineMap inside(map.width_px(), map.height_px());
  const int first = border_px, end = map.width_px() - border_px;  // of the columns kept
  if (first >= end) return inside;
  for (int y = border_px; y < map.height_px() - border_px; ++y) {
    for (int w = first / 64; w <= (end - 1) / 64; ++w) {
      uint64_t mask = ~uint64_t{0};
      if (w == first / 64) mask &= ~uint64_t{0} << (first % 64);
      if (w == (end - 1) / 64) mask &= ~uint64_t{0} >> (63 - (end - 1) % 64);
      inside.row(y)[w] = map.row(y)[w] & mask;
    }
  }
  return inside;
}

LineMap united(const LineMap& a, const LineMap& b) {
  assert(a.same_size(b));
  LineMap both = a;
  for (size_t i = 0; i < both.words().size(); ++i) both.words()[i] |= b.words()[i];
  return both;
}

bool LineCut::is_line(float sample) const {
  // Far under a step of 16 bits: 204 of 255 inverted is 51 whatever was rounded on the way.
  constexpr double kRounding = 1e-6;
  const double strength = inverted ? 1.0 - static_cast<double>(sample) : static_cast<double>(sample);
  return value == 0.0 ? strength > 0.0 : strength >= value - kRounding;
}

LineMap line_map_from(const Image& image, const LineCut& cut) {
  assert(image.channels == 1);
  LineMap map(image.width_px, image.height_px);
  for (int y = 0; y < map.height_px(); ++y) {
    const float* from = image.samples.data() + image.index(0, y);
    for (int x = 0; x < map.width_px(); ++x)
      map.row(y)[x >> 6] |= static_cast<uint64_t>(cut.is_line(from[x])) << (x & 63);
  }
  return map;
}

Picture picture_of(const LineMap& map) {
  Picture picture(map.width_px(), map.height_px(), 1);
  for_each_pixel(map, [&](int x, int y) { picture.at(x, y) = 255; });
  return picture;
}

}  // namespace inkbench
