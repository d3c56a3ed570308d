// SPDX-License-Identifier: MIT
#include "tests/fuzz/line_input.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace inkbench {
namespace {

void draw_bits(LineMap& map, Bytes& bytes) {
  for (int y = 0; y < map.height_px(); ++y) {
    for (int x = 0, bits = 0; x < map.width_px(); ++x) {
      bits = x % 8 == 0 ? bytes.byte() : bits;
      map.set(x, y, (bits >> (x % 8) & 1) != 0);
    }
  }
}

void draw_dots(LineMap& map, Bytes& bytes) {
  for (int left = bytes.byte() % 40; left > 0; --left)
    map.set(bytes.below(map.width_px()), bytes.below(map.height_px()));
}

/// Strokes that turn now and then, 1 to 4 px thick.
void draw_strokes(LineMap& map, Bytes& bytes) {
  for (int left = bytes.byte() % 8; left > 0; --left) {
    int x = bytes.below(map.width_px()), y = bytes.below(map.height_px());
    const int thickness = 1 + bytes.byte() % 4;
    for (int turns = bytes.byte() % 6; turns >= 0; --turns) {
      const int way = bytes.byte(), steps = bytes.byte() % 40;
      for (int step = 0; step < steps; ++step, x += way % 3 - 1, y += way / 3 % 3 - 1) {
        for (int i = 0; i < thickness * thickness; ++i) {
          const int dx = i % thickness, dy = i / thickness;
          if (map.contains(x + dx, y + dy)) map.set(x + dx, y + dy);
        }
      }
    }
  }
}

void draw_pattern(LineMap& map, Bytes& bytes) {
  const int columns = 1 + bytes.byte() % 9, rows = 1 + bytes.byte() % 9, on = bytes.byte() % 10;
  for (int y = 0; y < map.height_px(); ++y) {
    for (int x = 0; x < map.width_px(); ++x) map.set(x, y, x % columns + y % rows <= on);
  }
}

float read_coordinate(Bytes& bytes) {
  const int kind = bytes.byte();
  if (kind == 255) return std::numeric_limits<float>::quiet_NaN();
  if (kind == 254) return bytes.byte() % 2 == 0 ? INFINITY : -INFINITY;
  if (kind > 240) return static_cast<float>(bytes.below(60000)) - 30000.0F;
  return static_cast<float>(bytes.below(160 * 16)) / 16 - 10.0F;
}

}  // namespace

int Bytes::byte() {
  if (bytes_.empty()) return 0;
  const uint8_t first = bytes_[0];
  bytes_ = bytes_.subspan(1);
  return first;
}

int Bytes::below(int end) {
  const int number = byte() << 8 | byte();
  return end > 0 ? number % end : 0;
}

Tolerance read_tolerance(Bytes& bytes) {
  if (bytes.byte() % 2 == 0) {
    const int64_t square = bytes.below(10001);
    return {std::sqrt(static_cast<double>(square)), square};
  }
  const int64_t sixteenths = bytes.below(1601);
  return {static_cast<double>(sixteenths) / 16, sixteenths * sixteenths / 256};
}

LineMap read_size(Bytes& bytes) {
  const int width = bytes.byte() % 141, height = bytes.byte() % 41;
  return {width, width == 0 ? height : std::min(height, 1100 / width)};
}

LineMap read_map(Bytes& bytes, const LineMap& like) {
  LineMap map(like.width_px(), like.height_px());
  const int style = bytes.byte() % 6;
  if (map.words().empty() || style == 0) return map;
  if (style == 1) draw_bits(map, bytes);
  if (style == 2) draw_dots(map, bytes);
  if (style == 3) draw_strokes(map, bytes);
  if (style == 4) draw_pattern(map, bytes);
  if (style == 5) {
    const int dx = bytes.byte() % 7 - 3, dy = bytes.byte() % 7 - 3;
    for_each_pixel(like, [&](int x, int y) {
      if (map.contains(x + dx, y + dy)) map.set(x + dx, y + dy);
    });
  }
  return map;
}

std::vector<Polyline> read_polylines(Bytes& bytes) {
  std::vector<Polyline> lines(bytes.byte() % 4);
  for (Polyline& line : lines) {
    for (int left = bytes.byte() % 7; left > 0; --left) {
      const float x = read_coordinate(bytes);
      line.points.emplace_back(x, read_coordinate(bytes));
    }
  }
  return lines;
}

}  // namespace inkbench
