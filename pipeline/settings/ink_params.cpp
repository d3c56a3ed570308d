// SPDX-License-Identifier: MIT
#include "pipeline/settings/ink_params.h"

namespace inkbench {

const Description& InkParams::description() {
  static const Description kDescription{
      "ink",
      "Ink over the shading (3.5)",
      {
          field<&InkParams::from>(
              {.name = "from",
               .help = "filter: the lines that edges.method finds; strokes: curves, drawn as stroke.* says; "
                       "or both."}),
          colour_field<&InkParams::colour>(
              {.name = "colour", .help = "Colour of the lines; the paper's is black."}),
          field<&InkParams::over>(
              {.name = "over", .help = "What ink lies on: the shading, or a blank sheet."}),
          colour_field<&InkParams::paper>(
              {.name = "paper", .help = "Colour of the blank sheet.", .matters_when = "over = paper"}),
      }};
  return kDescription;
}

}  // namespace inkbench
