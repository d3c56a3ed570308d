// SPDX-License-Identifier: MIT
#include "pipeline/lines/line_map.h"

#include "pipeline/image/image_file.h"

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

LineMap line_map_from(const Picture& grey) {
  assert(grey.channels == 1);
  LineMap map(grey.width_px, grey.height_px);
  for (int y = 0; y < grey.height_px; ++y) {
    const uint8_t* from = grey.samples.data() + static_cast<size_t>(y) * grey.width_px;
    for (int x = 0; x < grey.width_px; ++x) {
      map.row(y)[x >> 6] |= static_cast<uint64_t>(from[x] > 127) << (x & 63);
    }
  }
  return map;
}

LineMap read_line_map(const std::filesystem::path& path) {
  return line_map_from(read_picture(path, 1));
}

Picture picture_of(const LineMap& map) {
  Picture picture(map.width_px(), map.height_px(), 1);
  for_each_pixel(map, [&](int x, int y) { picture.at(x, y) = 255; });
  return picture;
}

}  // namespace inkbench
