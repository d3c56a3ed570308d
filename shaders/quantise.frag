#version 450 core
// The normal and depth maps as an eight-bit framebuffer stores them; the target's format does the rounding.

uniform sampler2D normal_map;
uniform sampler2D depth_map;
layout(location = 0) out vec4 normal;
layout(location = 1) out float depth;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  normal = vec4(texelFetch(normal_map, at, 0).rgb, 1.0);
  depth = texelFetch(depth_map, at, 0).r;
}
