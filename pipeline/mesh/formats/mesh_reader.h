// SPDX-License-Identifier: MIT
// OpenMesh's readers: from a file's plain form to a polygon soup.
#pragma once

#include "pipeline/mesh/formats/mesh_source.h"
#include "pipeline/mesh/polygon_soup.h"

namespace inkbench {

/// Reads `source.bytes` through OpenMesh. Its readers are not to be trusted with bytes that `prepare_mesh`
/// has not seen, and with those only in `call_isolated`. Errors (input): the reader gave up; its own words.
PolygonSoup read_with_openmesh(const MeshSource& source);

}  // namespace inkbench
