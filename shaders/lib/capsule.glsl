// SPDX-License-Identifier: MIT
// Two discs and all discs between them, whose middle and radius go over from one to the other: a segment of a stroke.
// A point of a stroke is (x, y, radius, along), px.

struct Foot {
  float inside;  // how deep within the segment, px; below 0 outside
  float radius;  // of the disc that decides it
  float along;
  float aside;   // of the segment's line, px; above 0 on the right of its way, y down
  float beyond;  // so far before its start (below 0) or behind its end, px
};

Foot foot_on(vec2 here, vec4 from, vec4 to) {
  vec2 way = to.xy - from.xy;
  float size = length(way), safe = max(size, 1e-6);
  vec2 direction = way / safe;
  float slope = size > 0.0 ? (to.z - from.z) / safe : 0.0;
  float at = dot(here - from.xy, direction), aside = direction.x * (here.y - from.y) - direction.y * (here.x - from.x);
  // Where the radius grows by more than the way, one disc holds the other.
  float lean = abs(slope) < 0.999 ? slope * inversesqrt(1.0 - slope * slope) : sign(slope) * 1e6;
  float place = clamp(at + abs(aside) * lean, 0.0, size);
  float radius = from.z + slope * place;
  float along = mix(from.w, to.w, place / safe);
  return Foot(radius - length(vec2(at - place, aside)), radius, along, aside, at - clamp(at, 0.0, size));
}

// Of a stroke's pixel; one narrower than a pixel fades instead of vanishing.
float solid_share(Foot foot) { return clamp(foot.inside + 0.5, 0.0, min(1.0, 2.0 * foot.radius)); }
