// SPDX-License-Identifier: MIT
#include "pipeline/settings/scene_params.h"

namespace inkbench {

const Description& SceneParams::description() {
  static const Description kDescription{
      "scene",
      "The scene as a whole",
      {
          field<&SceneParams::ambient>({.name = "ambient",
                                        .help = "Global ambient light (red, green, blue) (3.1).",
                                        .limits = {0, 100},
                                        .slider = {0, 1}}),
          colour_field<&SceneParams::background>(
              {.name = "background", .help = "Colour where no model is drawn."}),
      }};
  return kDescription;
}

}  // namespace inkbench
