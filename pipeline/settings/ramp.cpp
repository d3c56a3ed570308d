// SPDX-License-Identifier: MIT
#include "pipeline/settings/ramp.h"

#include <algorithm>
#include <glm/common.hpp>

#include "pipeline/image/image_file.h"

namespace inkbench {
namespace {

std::vector<glm::vec3> image_table(const std::string& path) {
  const Image image = read_image(path);
  std::vector<glm::vec3> table(kRampTexels);
  for (int i = 0; i < kRampTexels; ++i) {
    const int x = static_cast<int>((i + 0.5) * image.width_px / kRampTexels);
    for (int c = 0; c < 3; ++c) table[i][c] = image.at(x, 0, image.channels >= 3 ? c : 0);
  }
  return table;
}

}  // namespace

const Description& RampParams::description() {
  static const Description kDescription{
      "ramp",
      "Limited colour palette (3.2)",
      {
          field<&RampParams::enabled>(
              {.name = "enabled", .help = "Look brightness up in the ramps; off is plain Blinn-Phong."}),
          field<&RampParams::diffuse>({.name = "diffuse",
                                       .help = "Ramp over N.L: a list of stops, or an image file.",
                                       .is_path = true,
                                       .matters_when = "enabled = true"}),
          field<&RampParams::specular>(
              {.name = "specular",
               .help = "Ramp over (N.H)^exponent: a list of stops, or an image file.",
               .is_path = true,
               .matters_when = "enabled = true"}),
      }};
  return kDescription;
}

glm::vec3 evaluate_ramp(const Ramp& ramp, float t) {
  if (ramp.stops.empty()) return glm::vec3(t);
  if (t < ramp.stops.front().position) return ramp.stops.front().colour;
  const auto next = std::upper_bound(ramp.stops.begin(), ramp.stops.end(), t,
                                     [](float value, const RampStop& stop) { return value < stop.position; });
  const RampStop& here = *(next - 1);
  if (here.stepped || next == ramp.stops.end()) return here.colour;
  return glm::mix(here.colour, next->colour, (t - here.position) / (next->position - here.position));
}

std::vector<glm::vec3> ramp_table(const Ramp& ramp) {
  if (!ramp.image.empty()) return image_table(ramp.image);
  std::vector<glm::vec3> table(kRampTexels);
  for (int i = 0; i < kRampTexels; ++i)
    table[i] = evaluate_ramp(ramp, (static_cast<float>(i) + 0.5F) / kRampTexels);
  return table;
}

}  // namespace inkbench
