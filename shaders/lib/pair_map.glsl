// SPDX-License-Identifier: MIT
// What the map of pairs holds of a pixel and its neighbours to the right and above: red and green, the angles between
// their surfaces in degrees, below 0 where a crease would be the neighbour's; blue and alpha, the gaps between their
// planes in pixels' sizes, below 0 where a step would be the neighbour's. Planes that meet between the two pixels' centres
// have no gap: there it says where they meet, as a share of the way to the neighbour times `meeting_gap`.

const float object_gap = 60000.0;   // between objects
const float largest_gap = 49152.0;  // of any other pair, a number that 16-bit floats have
const float meeting_gap = 0.00390625;  // no larger gap says where planes meet; no limit is as small
