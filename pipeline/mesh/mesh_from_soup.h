// SPDX-License-Identifier: MIT
// From a file's polygons to the mesh that is drawn: one point for each place, triangles, one sense of
// turning, normals corner by corner. In: a soup and what the model asks. Out: a mesh, with a note on every
// defect.
#pragma once

#include <string>

#include "pipeline/mesh/mesh.h"
#include "pipeline/mesh/polygon_soup.h"

namespace inkbench {

/// Edges between faces that differ by more than this are drawn sharp where a file does not say; the angle at
/// which `judge.crease_angle` expects a line.
inline constexpr double kSmoothAngleDeg = 40.0;

struct MeshOptions {
  bool use_file_normals = true;  ///< And smoothing groups, and the flat faces of formats that mean them.
  double smooth_below_deg = kSmoothAngleDeg;  ///< Elsewhere: 180 smooths all edges, 0 none.
  bool outwards = false;                      ///< Closed parts are turned so that their faces look outwards.
};

/// Puts equal places together, triangulates, drops what cannot be drawn, mends mixed senses of turning
/// (`find_orientation`), finds normals (`corner_normals` where the file gives a corner none). Each with a
/// note and count. Errors (input): no face, or none left; `where` is the file's name.
Mesh mesh_from_soup(const PolygonSoup& soup, const std::string& where, const MeshOptions& options = {});

}  // namespace inkbench
