// SPDX-License-Identifier: MIT
#include "pipeline/settings/combine_params.h"

namespace inkbench {

const Description& CombineParams::description() {
  static const Description kDescription{
      "combine",
      "Combining the edges (3.4.4)",
      {
          field<&CombineParams::k_depth>({.name = "k_depth",
                                          .help = "Sensitivity of the depth term: smaller draws more lines.",
                                          .limits = {1e-6, 1},
                                          .slider = {1e-4, 0.1},
                                          .scale = Scale::log,
                                          .matters_when = "use_depth = true"}),
          field<&CombineParams::k_normal>(
              {.name = "k_normal",
               .help = "Sensitivity of the normal term: smaller draws more lines.",
               .limits = {1e-6, 1},
               .slider = {1e-3, 0.5},
               .scale = Scale::log,
               .matters_when = "use_normal = true"}),
          field<&CombineParams::threshold>({.name = "threshold",
                                            .help = "A sum of terms under this draws no line.",
                                            .limits = {0, 2},
                                            .slider = {0, 2}}),
          field<&CombineParams::use_depth>(
              {.name = "use_depth", .help = "Count the depth term (off: Figure 10)."}),
          field<&CombineParams::use_normal>(
              {.name = "use_normal", .help = "Count the normal term (off: Figure 8)."}),
      },
      "edges.method = paper"};
  return kDescription;
}

}  // namespace inkbench
