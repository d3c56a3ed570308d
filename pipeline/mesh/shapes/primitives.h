// SPDX-License-Identifier: MIT
// Built-in shapes with adjustable tessellation, centred at the origin, faces counter-clockwise from outside
// (from inside for the inside-out sphere), normals exact for the shape that they approximate. Neighbouring
// triangles share vertices wherever the normal is continuous. `segments` is 1 or more.
#pragma once

#include "pipeline/mesh/mesh.h"

namespace inkbench {

/// Cube of side 1, each side a grid of `segments` x `segments` cells; normals are the sides', so edges are
/// sharp.
Mesh make_box(int segments);

/// Cube of side 1 whose edges and corners are rounded with radius `fillet` (0 to 0.5); `segments` cells along
/// a quarter arc, the flat sides undivided. A fillet of 0 gives the box, one of 0.5 a sphere of diameter 1.
Mesh make_rounded_box(int segments, float fillet);

/// Sphere of radius 1: `segments` rings from pole to pole (at least 2) and 2 x `segments` sectors around y
/// (at least 3); each pole is one vertex.
Mesh make_sphere(int segments);

/// The same sphere seen from within: faces and normals turned inwards.
Mesh make_inside_out_sphere(int segments);

/// Torus around the y axis: ring radius 1, tube radius `tube` (0 to 1, without both); 2 x `segments` sectors
/// around the ring, `segments` around the tube, both at least 3.
Mesh make_torus(int segments, float tube);

/// Square of side 1 in the xz plane, facing +y, a grid of `segments` x `segments` cells.
Mesh make_plane(int segments);

}  // namespace inkbench
