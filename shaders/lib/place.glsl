// SPDX-License-Identifier: MIT
// Where the drawn part lies in the image.

layout(std140) uniform place_block {
  vec2 middle_px;  // of the whole image, of which this may be a part
} place;
