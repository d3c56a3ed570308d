#version 450 core
// SPDX-License-Identifier: MIT
// The planes of a pixel's triangle and of its neighbours' to the right and above: the angle between them, and how far
// apart they are where they come closest between the two pixels' centres. A change of the limits does not compute it again.
#include "lib/lens.glsl"
#include "lib/place.glsl"
#include "lib/surface.glsl"
#include "lib/pair.glsl"

uniform sampler2D surface_map;
layout(location = 0) out vec4 pairs;  // lib/pair_map.glsl

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 size = textureSize(surface_map, 0);
  ivec2 right = ivec2(min(at.x + 1, size.x - 1), at.y), above = ivec2(at.x, min(at.y + 1, size.y - 1));
  vec2 from_middle = gl_FragCoord.xy - place.middle_px;
  Plane here = plane_at(texelFetch(surface_map, at, 0), from_middle);
  Plane beside = plane_at(texelFetch(surface_map, right, 0), from_middle + vec2(right - at));
  Plane over = plane_at(texelFetch(surface_map, above, 0), from_middle + vec2(above - at));
  vec2 chords = vec2(square_of_chord(here.normal, beside.normal), square_of_chord(here.normal, over.normal));
  vec2 bends = degrees_of_chord(chords);
  Misfit to_right = misfit(here.surface, beside.surface, here.surface.x, beside.surface.x);
  Misfit to_above = misfit(here.surface, over.surface, here.surface.y, over.surface.y);
  vec2 x = pair_of(here, beside, to_right, bends.x), y = pair_of(here, over, to_above, bends.y);
  vec2 has = vec2(notEqual(vec2(right.x, above.y), vec2(at)));  // not at the image's border
  pairs = vec4(x.x, y.x, x.y, y.y) * has.xyxy;
}
