// SPDX-License-Identifier: MIT
#include "pipeline/settings/light.h"

namespace inkbench {

const Description& LightParams::description() {
  static const Description kDescription{
      "light",
      "Lights (3.1), each under its name",
      {
          field<&LightParams::type>({.name = "type", .help = "Parallel light or light from a point."}),
          field<&LightParams::direction>({.name = "direction",
                                          .help = "Direction from the scene towards the light.",
                                          .limits = {-1, 1},
                                          .matters_when = "type = directional"}),
          field<&LightParams::position>({.name = "position",
                                         .help = "Where a point light is.",
                                         .unit = "world units",
                                         .limits = {-1e6, 1e6},
                                         .slider = {-10, 10},
                                         .matters_when = "type = point"}),
          field<&LightParams::ambient>({.name = "ambient",
                                        .help = "Ambient intensity (red, green, blue).",
                                        .limits = {0, 100},
                                        .slider = {0, 2}}),
          field<&LightParams::diffuse>({.name = "diffuse",
                                        .help = "Diffuse intensity (red, green, blue).",
                                        .limits = {0, 100},
                                        .slider = {0, 2}}),
          field<&LightParams::specular>({.name = "specular",
                                         .help = "Specular intensity (red, green, blue).",
                                         .limits = {0, 100},
                                         .slider = {0, 2}}),
      }};
  return kDescription;
}

}  // namespace inkbench
