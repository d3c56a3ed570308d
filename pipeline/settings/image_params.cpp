// SPDX-License-Identifier: MIT
#include "pipeline/settings/image_params.h"

namespace inkbench {

const Description& ImageParams::description() {
  static const Description kDescription{
      "image",
      "Image size and buffer precision",
      {
          field<&ImageParams::width>({.name = "width",
                                      .help = "Width of every buffer.",
                                      .unit = "px",
                                      .limits = {1, 32768},
                                      .slider = {64, 2048}}),
          field<&ImageParams::height>({.name = "height",
                                       .help = "Height of every buffer.",
                                       .unit = "px",
                                       .limits = {1, 32768},
                                       .slider = {64, 2048}}),
          field<&ImageParams::precision>({.name = "precision",
                                          .help = "Precision of the normal, depth, edge and combined "
                                                  "buffers; unorm8 shows what eight bits do."}),
      }};
  return kDescription;
}

}  // namespace inkbench
