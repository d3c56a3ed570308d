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
                                          .help =
                                              "What lines are found in: 32-bit floats; unorm8: normals, "
                                              "depths, edges and sums in eight bits; half: normals and "
                                              "depths in 16-bit floats; depth24: normals in 16-bit floats, "
                                              "depths as 24-bit window depths between near and far."}),
          field<&ImageParams::supersample>(
              {.name = "supersample",
               .help = "Pictures of colours and of coverage are drawn so many times as wide and as high and "
                       "filtered down; widths of lines are still in their pixels. Other buffers and all raw "
                       "values stay as they are.",
               .limits = {1, 8}}),
      }};
  return kDescription;
}

}  // namespace inkbench
