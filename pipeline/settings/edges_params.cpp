// SPDX-License-Identifier: MIT
#include "pipeline/settings/edges_params.h"

namespace inkbench {

const Description& EdgesParams::description() {
  static const Description kDescription{
      "edges",
      "Finding the lines",
      {
          field<&EdgesParams::method>(
              {.name = "method",
               .help = "The detector: paper is Scheelk's; dihedral, by an angle in degrees, is ours."}),
          field<&EdgesParams::weak>(
              {.name = "weak",
               .help = "A pixel from this share of the limit on goes on with a line that reaches the limit "
                       "somewhere (hysteresis); 1: each pixel by itself.",
               .limits = {0.05, 1},
               .matters_when = "method != paper"}),
          field<&EdgesParams::min_length>({.name = "min_length",
                                           .help = "Shorter connected lines are left out.",
                                           .unit = "px",
                                           .limits = {0, 10000},
                                           .slider = {0, 50},
                                           .matters_when = "method != paper"}),
      }};
  return kDescription;
}

}  // namespace inkbench
