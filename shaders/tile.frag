#version 450 core
// SPDX-License-Identifier: MIT
// A part of a picture at the window's size: the mean of the picture pixels that a window pixel covers; when magnified, the
// nearest one.

uniform sampler2D picture_map;
uniform sampler2D overlay_map;  // lines over a picture of the same size, clear where there is none
layout(std140) uniform tile_block {
  float left, top;  // the picture's point at the tile's top left corner, in picture pixels, y down
  float step;       // picture pixels a window pixel
  int height_px;    // of the tile
  float veil;       // how much the picture fades to white below the overlay; below 0: there is none
} tile;
layout(location = 0) out vec4 colour;

const int max_taps = 8;  // a side: beyond it taps are spread out

// Row 0 is the picture's top one; the texture's is its bottom one.
vec4 picture_at(ivec2 place, ivec2 size) {
  return vec4(texelFetch(picture_map, ivec2(place.x, size.y - 1 - place.y), 0).rgb, 1.0);
}

// Premultiplied.
vec4 overlay_at(ivec2 place, ivec2 size) {
  vec4 line = texelFetch(overlay_map, ivec2(place.x, size.y - 1 - place.y), 0);
  return vec4(line.rgb * line.a, line.a);
}

// Lines keep a window pixel's width however small the picture is: `share` is how much of the pixel they cover.
vec4 with_overlay(vec4 base, vec4 lines, float share) {
  if (tile.veil < 0.0) return base;
  vec3 below = mix(base.rgb, vec3(1.0), tile.veil);
  if (lines.a <= 0.0) return vec4(below, base.a);
  return vec4(mix(below, lines.rgb / lines.a, min(share * max(tile.step, 1.0), 1.0)), base.a);
}

// How much of picture pixel `i` lies between `low` and `high`.
float covered(float i, float low, float high) {
  return max(min(i + 1.0, high) - max(i, low), 0.0);
}

vec4 mean_of(vec2 low, ivec2 size) {
  vec2 high = low + tile.step;
  float stride = max(1.0, ceil(tile.step / float(max_taps)));
  vec4 sum = vec4(0.0);
  vec4 lines = vec4(0.0);
  float weights = 0.0;
  for (float y = floor(low.y); y < high.y; y += stride) {
    for (float x = floor(low.x); x < high.x; x += stride) {
      float weight = covered(x, low.x, high.x) * covered(y, low.y, high.y);
      weights += weight;
      bool inside = x >= 0.0 && y >= 0.0 && x < float(size.x) && y < float(size.y);
      if (!inside) continue;
      sum += weight * picture_at(ivec2(x, y), size);
      if (tile.veil >= 0.0) lines += weight * overlay_at(ivec2(x, y), size);
    }
  }
  if (sum.a <= 0.0) return vec4(0.0);
  return with_overlay(vec4(sum.rgb / sum.a, sum.a / weights), lines, lines.a / weights);
}

void main() {
  ivec2 size = textureSize(picture_map, 0);
  vec2 pixel = vec2(gl_FragCoord.x, float(tile.height_px) - gl_FragCoord.y);
  vec2 centre = vec2(tile.left, tile.top) + pixel * tile.step;
  if (tile.step > 1.0) {
    colour = mean_of(centre - 0.5 * tile.step, size);
    return;
  }
  ivec2 nearest = ivec2(floor(centre));
  bool inside = all(greaterThanEqual(nearest, ivec2(0))) && all(lessThan(nearest, size));
  if (!inside) {
    colour = vec4(0.0);
    return;
  }
  vec4 lines = tile.veil >= 0.0 ? overlay_at(nearest, size) : vec4(0.0);
  colour = with_overlay(picture_at(nearest, size), lines, lines.a);
}
