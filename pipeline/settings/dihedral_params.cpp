// SPDX-License-Identifier: MIT
#include "pipeline/settings/dihedral_params.h"

namespace inkbench {

const Description& DihedralParams::description() {
  static const Description kDescription{
      "dihedral",
      "Ours: angles and gaps between neighbours' planes",
      {
          field<&DihedralParams::angle>({.name = "angle",
                                         .help = "Surfaces that meet at so large an angle have a line.",
                                         .unit = "deg",
                                         .limits = {0.1, 180},
                                         .slider = {5, 90}}),
          field<&DihedralParams::gap>(
              {.name = "gap",
               .help = "A pixel so far off its neighbour's plane, and the other way round, is on another "
                       "surface; in pixels' sizes where it is.",
               .unit = "px",
               .limits = {0.01, kMostGap},
               .slider = {0.1, 10},
               .scale = Scale::log}),
          field<&DihedralParams::normals>(
              {.name = "normals",
               .help = "Bends are of the triangles themselves (surface), of the normals that light sees "
                       "(shading: coarse meshes that are shaded smoothly), or of either (both)."}),
      },
      "edges.method = dihedral"};
  return kDescription;
}

}  // namespace inkbench
