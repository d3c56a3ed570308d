// SPDX-License-Identifier: MIT
// Where a brush touches the paper, and the randomness of paper and brush, which is the stroke's own: it stays on the
// stroke when the view turns.

struct Touch {
  Foot foot;
  float along;       // px
  float across;      // -1 on the left edge to 1 on the right one
  float start, end;  // of the stroke, as `along`
  uint seed;
};

uint mixed(uint bits) {
  bits ^= bits >> 16;
  bits *= 0x85ebca6bu;
  bits ^= bits >> 13;
  bits *= 0xc2b2ae35u;
  return bits ^ (bits >> 16);
}

// 0 to 1, the same for the same place.
float random_of(ivec2 place, uint seed) {
  uint bits = mixed(uint(place.x) * 0x9e3779b9u ^ mixed(uint(place.y) + seed));
  return float(bits >> 8) / 16777216.0;
}

// Smooth noise, 0 to 1, that changes over a length of about 1.
float noise_at(vec2 at, uint seed) {
  vec2 low = floor(at), t = at - low;
  ivec2 place = ivec2(low);
  vec2 s = t * t * (3.0 - 2.0 * t);
  float above = mix(random_of(place, seed), random_of(place + ivec2(1, 0), seed), s.x);
  float below = mix(random_of(place + ivec2(0, 1), seed), random_of(place + ivec2(1, 1), seed), s.x);
  return mix(above, below, s.y);
}

// In repetitions of the paint: by how many the stroke is long here, or which share of it.
float repetition_at(Touch touch) {
  if (strokes.is_stretched != 0) return (touch.along - touch.start) / max(touch.end - touch.start, 1e-3);
  return touch.along / strokes.length_px;
}
