// SPDX-License-Identifier: MIT
// Small meshes as files' content, for tests that hand them to the program.
#pragma once

#include <string>

namespace inkbench {

/// A cube of that side with its lower corner at (corner, corner, corner).
std::string cube_off(double side, double corner);

/// The unit cube, from 0 to 1.
std::string cube_obj();
std::string cube_ply();
std::string cube_stl();

/// A waved sheet of `cells` x `cells` squares, two triangles each, as binary PLY.
std::string wave_ply(int cells);

/// Bytes that are no file format, the same each time.
std::string junk(size_t bytes);

}  // namespace inkbench
