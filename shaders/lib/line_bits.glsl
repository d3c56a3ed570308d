// SPDX-License-Identifier: MIT
// Which pixels have a line, 8 x 8 of them to a texel: a byte for each row, the lowest row and the leftmost pixel in the lowest
// bits. Needs the sampler bit_map. All lines near a pixel are found with four looks, and only pixels that have one are visited.

// Of pixels outside the image none has one.
uvec2 bits_of_tile(ivec2 tile) {
  ivec2 place = clamp(tile, ivec2(0), textureSize(bit_map, 0) - 1);
  uvec2 bits = texelFetch(bit_map, place, 0).rg;
  return place == tile ? bits : uvec2(0u);
}

// Of the 8 x 8 pixels from any `low` on.
uvec2 bits_from(ivec2 low) {
  ivec2 tile = low >> 3, into = low & 7;
  uvec4 left = uvec4(bits_of_tile(tile), bits_of_tile(tile + ivec2(0, 1)));
  uvec4 right = uvec4(bits_of_tile(tile + ivec2(1, 0)), bits_of_tile(tile + ivec2(1, 1)));
  uint from_left = (0xffu >> into.x) * 0x01010101u;  // the part of each byte that the tile on the left has
  uvec4 rows = (left >> into.x & from_left) | (right << (8 - into.x) & ~from_left);
  uvec3 words = into.y < 4 ? rows.xyz : rows.yzw;
  int down = 8 * (into.y & 3);
  return words.xy >> down | (words.yz << 1) << (31 - down);
}
