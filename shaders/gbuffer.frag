#version 450 core
// SPDX-License-Identifier: MIT
// G-buffer: all geometry that later passes read, in one pass (the paper's future work 5.1).
#include "lib/gbuffer_maps.glsl"

void main() { write_maps(); }
