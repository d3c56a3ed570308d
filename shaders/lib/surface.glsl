// SPDX-License-Identifier: MIT
// The plane of the triangle that a pixel shows, as the G-buffer's surface map holds it: xy, t = N.xy / (N.D) with N the
// triangle's normal in view space and D the ray through the pixel's centre, one unit long along the view; z, the distance
// along the view; w, the object's id, 0 where no model is. With N scaled so that N.D = 1, N.z follows from t. d pixels
// away the plane has 1/z' = (1 + t.d s) / z; in orthographic views z' = z - t.d s, with s the pixel's size.
// Needs lib/lens.glsl.

// A plane seen edge on has no finite t.
const float least_facing = 1e-6;

// D.xy of a pixel, `from_middle` pixels from the image's middle.
vec2 ray_through(vec2 from_middle) { return lens.is_orthographic != 0 ? vec2(0.0) : from_middle * lens.pixel_size; }

vec4 surface_of(vec3 normal_view, vec2 ray, float distance, float id) {
  float facing = dot(normal_view, vec3(ray, -1.0));
  facing = abs(facing) < least_facing ? least_facing : facing;
  return vec4(normal_view.xy / facing, distance, id);
}

// N, not of unit length, away from the eye.
vec3 surface_normal(vec4 surface, vec2 ray) { return vec3(surface.xy, dot(surface.xy, ray) - 1.0); }
