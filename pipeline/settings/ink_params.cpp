// SPDX-License-Identifier: MIT
#include "pipeline/settings/ink_params.h"

namespace inkbench {

const Description& InkParams::description() {
  static const Description kDescription{
      "ink",
      "Ink over the shading (3.5)",
      {
          colour_field<&InkParams::colour>(
              {.name = "colour", .help = "Colour of the lines; the paper's is black."}),
      }};
  return kDescription;
}

}  // namespace inkbench
