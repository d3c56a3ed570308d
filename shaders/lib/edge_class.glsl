// SPDX-License-Identifier: MIT
// What a detected pixel is of, as detections hold it (measures.md 6).

const float class_none = 0.0;
const float class_object = 1.0;
const float class_silhouette = 2.0;
const float class_crease = 3.0;
const float class_normal = 4.0;
const float class_shadow = 5.0;
const float class_material = 6.0;

// Of a detector that does not tell it: the surfaces up to `reach` pixels away do, as far as its operator sees
// (edge_class.frag).
float class_of_surfaces(int reach) { return -float(reach); }
