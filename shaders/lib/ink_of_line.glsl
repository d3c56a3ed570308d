// SPDX-License-Identifier: MIT
// The ink of a pixel by its nearest line, unless a surface in front hides that. Needs lib/lens.glsl, lib/pieces.glsl,
// the sampler normal_and_depth_map, `uint seeds_around(ivec2 of_line, bool is_asked)`, which of the pixels around have a line,
// and `float coverage_of(vec2 here, vec4 from, uint links)`.

float depth_at(ivec2 at) {
  return texelFetch(normal_and_depth_map, clamp(at, ivec2(0), textureSize(normal_and_depth_map, 0) - 1), 0).a;
}

// Does the pixel show a surface in front of the line's? One that goes on from the line's own comes nearer no more than
// three times as fast as it does here.
bool is_in_front(ivec2 at, ivec2 of_line, bool is_asked) {
  float own = depth_at(at), lines = depth_at(of_line);
  bool is_nearer = is_asked && !is_background(own) && own < lines;
  float here = affine_depth(own);
  vec2 slope = vec2(1e30);
  int sides = is_nearer ? 2 : 0;
  for (int i = 0; i < sides; ++i) {
    int d = 2 * i - 1;
    slope = min(slope, abs(vec2(affine_depth(depth_at(at + ivec2(d, 0))), affine_depth(depth_at(at + ivec2(0, d)))) - here));
  }
  float explained = dot(slope, abs(vec2(at - of_line)));
  return is_nearer && in_pixel_sizes(max(abs(here - affine_depth(lines)) - 3.0 * explained, 0.0), here) > 2.0;
}

// Coverage and class / 255 of a pixel by its nearest seed; 0 where none `is_near`. Loops without turns cost little, branches
// all that they skip.
vec2 ink_of(ivec2 at, vec4 nearest, bool is_near) {
  ivec2 of_line = ivec2(floor(nearest.xy));
  float covered = coverage_of(vec2(at) + 0.5, nearest, links_of(seeds_around(of_line, is_near)));
  if (!is_near || covered <= 0.0 || is_in_front(at, of_line, covered > 0.0)) return vec2(0.0);
  return vec2(covered, nearest.a / 255.0);
}
