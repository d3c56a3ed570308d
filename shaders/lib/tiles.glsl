// SPDX-License-Identifier: MIT
// Whether there is a line in a part of the image, by tiles of 8 x 8 pixels. Needs the sampler tile_map.

// Of pixels from `low` to `high`.
bool has_line_in(ivec2 low, ivec2 high) {
  ivec2 last = textureSize(tile_map, 0) - 1;
  ivec2 first = clamp(low / 8, ivec2(0), last), end = clamp(high / 8, ivec2(0), last);
  float found = 0.0;
  for (int y = first.y; y <= end.y; ++y)
    for (int x = first.x; x <= end.x; ++x) found += texelFetch(tile_map, ivec2(x, y), 0).r;
  return found > 0.0;
}
