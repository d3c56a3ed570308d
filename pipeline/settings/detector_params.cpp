// SPDX-License-Identifier: MIT
#include "pipeline/settings/detector_params.h"

namespace inkbench {
namespace {

constexpr std::string_view kThinHelp =
    "Draw lines of line.width along the middle of what it finds, instead of what it finds itself.";

}  // namespace

const Description& DecaudinParams::description() {
  static const Description kDescription{
      "decaudin",
      "Decaudin's detector (1996)",
      {
          field<&DecaudinParams::k_depth>(
              {.name = "k_depth",
               .help = "Range of the depth's gradient that is full ink; from 0.71 of it on it is "
                       "a line.",
               .unit = "share of far",
               .limits = {1e-7, 1},
               .slider = {1e-4, 0.1},
               .scale = Scale::log}),
          field<&DecaudinParams::k_normal>(
              {.name = "k_normal",
               .help =
                   "Range of the gradient of any component of the normal map (0.5 N + 0.5) that is full ink.",
               .limits = {1e-6, 10},
               .slider = {1e-2, 1},
               .scale = Scale::log}),
          field<&DecaudinParams::thin>({.name = "thin", .help = kThinHelp}),
      },
      "edges.method = decaudin"};
  return kDescription;
}

const Description& SaitoTakahashiParams::description() {
  static const Description kDescription{
      "saito_takahashi",
      "Saito and Takahashi's detector (1990)",
      {
          field<&SaitoTakahashiParams::profile>(
              {.name = "profile",
               .help = "First difference within a pixel of the depth from the nearest, 0, to the farthest "
                       "visible surface, 1, that is a profile.",
               .unit = "share of the visible depth",
               .limits = {1e-7, 10},
               .slider = {1e-3, 0.2},
               .scale = Scale::log}),
          field<&SaitoTakahashiParams::crease>(
              {.name = "crease",
               .help = "Change of the same difference from one pixel to the next that is a crease.",
               .unit = "share of the visible depth",
               .limits = {1e-7, 10},
               .slider = {1e-4, 0.1},
               .scale = Scale::log}),
          field<&SaitoTakahashiParams::thin>({.name = "thin", .help = kThinHelp}),
      },
      "edges.method = saito_takahashi"};
  return kDescription;
}

const Description& MitchellParams::description() {
  static const Description kDescription{
      "mitchell",
      "Mitchell, Brennan and Card's detector (2002)",
      {
          field<&MitchellParams::angle>({.name = "angle",
                                         .help = "Neighbours' shading normals so far apart are a line.",
                                         .unit = "deg",
                                         .limits = {0.1, 180},
                                         .slider = {5, 90}}),
          field<&MitchellParams::depth>({.name = "depth",
                                         .help = "Neighbours' depths so far apart are a line.",
                                         .unit = "share of far",
                                         .limits = {1e-7, 1},
                                         .slider = {1e-4, 0.1},
                                         .scale = Scale::log}),
          field<&MitchellParams::use_ids>({.name = "use_ids", .help = "Where two models meet is a line."}),
          field<&MitchellParams::albedo>({.name = "albedo",
                                          .help = "Neighbours' materials whose colours differ by so much, in "
                                                  "any channel, are a line.",
                                          .limits = {0.001, 2},
                                          .slider = {0.01, 1}}),
          field<&MitchellParams::thin>({.name = "thin", .help = kThinHelp}),
      },
      "edges.method = mitchell"};
  return kDescription;
}

const Description& LaplacianParams::description() {
  static const Description kDescription{
      "laplacian",
      "The Laplacian of 1/z",
      {
          field<&LaplacianParams::bend>(
              {.name = "bend",
               .help =
                   "How much the slope of the surface against the image changes around a pixel where a line "
                   "is. At a right angle it is 2 or more, of which the nearest pixel sees at least half.",
               .limits = {1e-4, 1e4},
               .slider = {0.05, 5},
               .scale = Scale::log}),
      },
      "edges.method = laplacian"};
  return kDescription;
}

}  // namespace inkbench
