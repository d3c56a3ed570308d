// SPDX-License-Identifier: MIT
#include "pipeline/settings/line_params.h"

namespace inkbench {
namespace {

constexpr std::string_view kNotThePapers = "edges.method != paper";

}  // namespace

const Description& LineParams::description() {
  static const Description kDescription{
      "line",
      "Width and look of the lines",
      {
          field<&LineParams::width>({.name = "width",
                                     .help = "Of lines whose class says nothing else, in line.unit.",
                                     .limits = {1e-6, 1e6},
                                     .slider = {0.5, 8}}),
          field<&LineParams::unit>(
              {.name = "unit",
               .help = "Of the width: pixels, percent of the image's height (the same picture at any size), "
                       "or world units (thinner with distance)."}),
          field<&LineParams::taper>({.name = "taper",
                                     .help = "Lines become thin over this length towards their ends.",
                                     .unit = "px",
                                     .limits = {0, 10000},
                                     .slider = {0, 100}}),
          field<&LineParams::depth_taper>(
              {.name = "depth_taper",
               .help = "How much thinner the farthest visible lines are than the nearest ones; 1: they "
                       "vanish.",
               .limits = {0, 1}}),
          field<&LineParams::antialias>(
              {.name = "antialias",
               .help = "Pixels take as much ink as the line covers of them; off: all or none."}),
          field<&LineParams::colour_by_class>(
              {.name = "colour_by_class", .help = "Each class has its own colour instead of ink.colour."}),
      },
      kNotThePapers};
  return kDescription;
}

ClassLooks default_class_looks() {
  constexpr std::array<glm::vec3, kEdgeClasses> kColours{{{0.0F, 0.0F, 0.0F},
                                                          {0.0F, 0.447F, 0.698F},
                                                          {0.835F, 0.369F, 0.0F},
                                                          {0.0F, 0.62F, 0.451F},
                                                          {0.8F, 0.475F, 0.655F},
                                                          {0.902F, 0.624F, 0.0F}}};
  ClassLooks looks;
  for (size_t i = 0; i < kEdgeClasses; ++i) looks[i].colour = kColours[i];
  return looks;
}

const Description& ClassLookParams::description() {
  static const Description kDescription{
      "line_class",
      "Lines of one class",
      {
          field<&ClassLookParams::width>({.name = "width",
                                          .help = "Times line.width; 0 draws none of them.",
                                          .limits = {0, 100},
                                          .slider = {0, 4}}),
          colour_field<&ClassLookParams::colour>(
              {.name = "colour", .help = "Their colour.", .matters_when = "line.colour_by_class = true"}),
          field<&ClassLookParams::opacity>(
              {.name = "opacity", .help = "How much of the shading they hide.", .limits = {0, 1}}),
      },
      kNotThePapers};
  return kDescription;
}

}  // namespace inkbench
