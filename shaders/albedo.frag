#version 450 core
// SPDX-License-Identifier: MIT
// Each pixel's material: its colour, and which it is. Deferred: ids say the model, and the table its material.

uniform sampler2D object_id_map;
uniform sampler2D material_table;  // by model, in rows: colour, number of the material
layout(location = 0) out vec4 albedo;  // colour, number of the material; all 0 where no model is

void main() {
  int model = int(texelFetch(object_id_map, ivec2(gl_FragCoord.xy), 0).r + 0.5) - 1;
  int row = textureSize(material_table, 0).x;
  albedo = model < 0 ? vec4(0.0) : texelFetch(material_table, ivec2(model % row, model / row), 0);
}
