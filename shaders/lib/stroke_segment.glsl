// SPDX-License-Identifier: MIT
// What a fragment of a stroke's segment is of. Needs `float painted(Touch touch)`: how much paint there is, 0 to 1.

layout(location = 0) flat in vec4 points[6];
layout(location = 6) flat in vec4 paint;
layout(location = 0) out vec4 first_classes;
layout(location = 1) out vec4 next_classes;
layout(location = 2) out vec4 last_classes;

// Whether a neighbour is nearer. Its foot may be the segment's own end; then both draw the same.
bool is_nearer(vec2 here, int from, float inside) {
  if (points[from].z < 0.0 || points[from + 1].z < 0.0) return false;
  return foot_on(here, points[from], points[from + 1]).inside > inside + 1e-3;
}

// Along a closed stroke paint goes over from its end to its start, lane by lane, somewhere in the last fifth.
float closed_along(float along, float across) {
  float round = paint.w - paint.z;
  float lane = random_of(ivec2(int(floor(6.0 * across)), 77), uint(paint.x));
  return paint.w - along < 0.2 * round * lane ? along - round : along;
}

Touch touch_at(vec2 here) {
  Foot foot = foot_on(here, points[2], points[3]);
  float across = clamp(foot.aside / max(foot.radius, 1e-3), -1.0, 1.0);
  bool is_free = foot.beyond < 0.0 ? points[1].z < 0.0 : points[4].z < 0.0;
  float along = foot.along + (is_free ? foot.beyond : 0.0);
  if ((flags_of(paint) & closed_flag) != 0 && strokes.is_stretched == 0) along = closed_along(along, across);
  return Touch(foot, along, across, paint.z, paint.w, uint(paint.x));
}

void main() {
  vec2 here = from_fragment(gl_FragCoord.xy);
  Touch touch = touch_at(here);
  float inside = touch.foot.inside;
  if (inside <= -0.5) discard;
  if (is_nearer(here, 1, inside) || is_nearer(here, 3, inside) || is_nearer(here, 0, inside) || is_nearer(here, 4, inside))
    discard;
  float share = painted(touch) * ((flags_of(paint) & hidden_flag) != 0 ? strokes.hidden_share : 1.0);
  int of_class = class_of(paint);
  vec4 places = vec4(0.0, 1.0, 2.0, 3.0);
  first_classes = share * vec4(equal(places, vec4(of_class)));
  next_classes = share * vec4(equal(places, vec4(of_class - 4)));
  last_classes = share * vec4(equal(places, vec4(of_class - 8)));
}
