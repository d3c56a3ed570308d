// SPDX-License-Identifier: MIT
#include "pipeline/settings/mesh_params.h"

namespace inkbench {

const Description& MeshParams::description() {
  static const Description kDescription{
      "mesh",
      "Triangle count of the main model",
      {
          field<&MeshParams::faces>({.name = "faces",
                                     .help = "Decimate the main model to this many triangles; 0 keeps all.",
                                     .unit = "triangles",
                                     .limits = {0, kMaxSubdividedFaces},
                                     .slider = {100, 100000},
                                     .scale = Scale::log,
                                     .zero_text = "all"}),
          field<&MeshParams::subdivide>({.name = "subdivide",
                                         .help = "Rounds of Loop subdivision, each four times the triangles; "
                                                 "decimation comes after it.",
                                         .limits = {0, kMaxSubdivisionRounds}}),
          field<&MeshParams::normals>(
              {.name = "normals",
               .help = "Vertex normals of the main model: as the model has them, smooth over its own faces, "
                       "flat, or those of the full mesh at the nearest point, as baked normals are."}),
      }};
  return kDescription;
}

}  // namespace inkbench
