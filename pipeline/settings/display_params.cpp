// SPDX-License-Identifier: MIT
#include "pipeline/settings/display_params.h"

namespace inkbench {

const Description& DisplayParams::description() {
  static const Description kDescription{
      "display",
      "Pictures of the buffers",
      {
          field<&DisplayParams::depth_gain>({.name = "depth_gain",
                                             .help = "The depth picture is multiplied by this.",
                                             .limits = {1e-3, 1e6},
                                             .slider = {0.1, 100},
                                             .scale = Scale::log}),
          field<&DisplayParams::depth_edges_gain>({.name = "depth_edges_gain",
                                                   .help = "The depth edges' picture is multiplied by this.",
                                                   .limits = {1e-3, 1e6},
                                                   .slider = {1, 1000},
                                                   .scale = Scale::log}),
          field<&DisplayParams::normal_edges_gain>(
              {.name = "normal_edges_gain",
               .help = "The normal edges' picture is multiplied by this.",
               .limits = {1e-3, 1e6},
               .slider = {1, 1000},
               .scale = Scale::log}),
          field<&DisplayParams::strength_gain>(
              {.name = "strength_gain",
               .help =
                   "The edge strength's picture is multiplied by this: at a half, white is twice the limit.",
               .limits = {1e-3, 1e6},
               .slider = {0.05, 10},
               .scale = Scale::log}),
          field<&DisplayParams::pair_angles_gain>(
              {.name = "pair_angles_gain",
               .help = "The picture of the angles to the neighbours is multiplied by this.",
               .limits = {1e-6, 1e6},
               .slider = {1e-3, 0.1},
               .scale = Scale::log,
               .matters_when = "edges.method = dihedral"}),
      }};
  return kDescription;
}

}  // namespace inkbench
