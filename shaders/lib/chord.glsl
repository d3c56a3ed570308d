// SPDX-License-Identifier: MIT
// Angles by the chord between unit vectors: the arc cosine of a product near 1 has no digits left.

float square_of_chord(vec3 a, vec3 b) { return dot(a - b, a - b); }
vec2 degrees_of_chord(vec2 square) { return degrees(2.0 * asin(min(0.5 * sqrt(square), 1.0))); }
