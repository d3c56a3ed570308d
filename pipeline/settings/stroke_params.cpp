// SPDX-License-Identifier: MIT
#include "pipeline/settings/stroke_params.h"

#include <charconv>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

std::vector<Field> width_fields() {
  return {
      field<&StrokeParams::width>({.name = "width",
                                   .help = "Of strokes whose class says nothing else, in stroke.unit.",
                                   .limits = {1e-6, 1e6},
                                   .slider = {0.5, 16}}),
      field<&StrokeParams::unit>({.name = "unit",
                                  .help = "Of the width: pixels, percent of the image's height, or world "
                                          "units (thinner with distance)."}),
      field<&StrokeParams::outline>(
          {.name = "outline",
           .help = "Times the width, of outlines behind which there is another object or nothing.",
           .limits = {0, 100},
           .slider = {0, 4}}),
      field<&StrokeParams::depth_taper>(
          {.name = "depth_taper",
           .help = "How much thinner the farthest strokes are than the nearest ones; 1: they vanish.",
           .limits = {0, 1}}),
      field<&StrokeParams::curvature_width>(
          {.name = "curvature_width",
           .help = "How much thicker strokes are where they bend; 1: twice as thick in a bend as narrow as "
                   "the stroke is wide ten times.",
           .limits = {-1, 10},
           .slider = {-1, 2}}),
      field<&StrokeParams::shadow_width>(
          {.name = "shadow_width",
           .help = "How much thicker strokes are in the dark: 1: twice as thick where the shading is black.",
           .limits = {-1, 10},
           .slider = {-1, 3}}),
      field<&StrokeParams::taper_in>(
          {.name = "taper_in",
           .help = "Strokes swell to their width over this length from their start.",
           .unit = "px",
           .limits = {0, 10000},
           .slider = {0, 100}}),
      field<&StrokeParams::taper_out>({.name = "taper_out",
                                       .help = "Strokes thin out over this length towards their end.",
                                       .unit = "px",
                                       .limits = {0, 10000},
                                       .slider = {0, 100}}),
      field<&StrokeParams::tip>(
          {.name = "tip", .help = "Share of the width that tapered ends keep.", .limits = {0, 1}}),
      field<&StrokeParams::profile>(
          {.name = "profile",
           .help = "Width along the stroke from its start, 0, to its end, 1, as pairs of a place and a share "
                   "of the width: \"0 0.2, 0.5 1, 1 0\"; empty: all of it.",
           .is_profile = true}),
  };
}

std::vector<Field> course_fields() {
  return {
      field<&StrokeParams::overshoot>({.name = "overshoot",
                                       .help = "Strokes go on straight by this much beyond their ends.",
                                       .unit = "px",
                                       .limits = {0, 1000},
                                       .slider = {0, 30}}),
      field<&StrokeParams::bridge>({.name = "bridge",
                                    .help = "Gaps that are shorter than this are drawn over where two "
                                            "strokes go on in one another's direction.",
                                    .unit = "px",
                                    .limits = {0, 1000},
                                    .slider = {0, 40}}),
      field<&StrokeParams::shortest>({.name = "shortest",
                                      .help = "Shorter strokes are left out.",
                                      .unit = "px",
                                      .limits = {0, 10000},
                                      .slider = {0, 60}}),
      field<&StrokeParams::smoothing>(
          {.name = "smoothing",
           .help = "Standard deviation of the Gaussian along the stroke that evens its course.",
           .unit = "px",
           .limits = {0, 100},
           .slider = {0, 10}}),
      field<&StrokeParams::wobble>({.name = "wobble",
                                    .help = "How far the hand strays.",
                                    .unit = "px",
                                    .limits = {0, 100},
                                    .slider = {0, 6}}),
      field<&StrokeParams::wobble_length>({.name = "wobble_length",
                                           .help = "Over which length it strays.",
                                           .unit = "px",
                                           .limits = {1, 10000},
                                           .slider = {5, 200},
                                           .scale = Scale::log,
                                           .matters_when = "wobble != 0"}),
      field<&StrokeParams::passes>({.name = "passes",
                                    .help = "How often each stroke is drawn, each time a little elsewhere.",
                                    .limits = {1, 16},
                                    .slider = {1, 5}}),
      field<&StrokeParams::spread>({.name = "spread",
                                    .help = "How far the passes stray from each other.",
                                    .unit = "px",
                                    .limits = {0, 100},
                                    .slider = {0, 6},
                                    .matters_when = "passes != 1"}),
      field<&StrokeParams::seed>({.name = "seed",
                                  .help = "Another number, another hand.",
                                  .limits = {0, 1000000},
                                  .slider = {0, 20}}),
  };
}

std::vector<Field> paint_fields() {
  return {
      field<&StrokeParams::colour>({.name = "colour",
                                    .help = "ink: ink.colour; class: each class its own; material: that of "
                                            "the surface; shading: the shaded picture's below."}),
      field<&StrokeParams::darken>({.name = "darken",
                                    .help = "How much darker than the material or the shading.",
                                    .limits = {0, 1},
                                    .matters_when = "colour = material or shading"}),
      field<&StrokeParams::opacity>(
          {.name = "opacity", .help = "How much of the shading strokes hide.", .limits = {0, 1}}),
      field<&StrokeParams::brush>(
          {.name = "brush",
           .help = "solid; ink: a loaded brush that splits where it runs dry; pencil and charcoal: on the "
                   "grain of paper; marker: darker at its edges; image: brush_image."}),
      field<&StrokeParams::brush_image>(
          {.name = "brush_image",
           .help = "Picture whose darkness (where it has alpha, alpha) is the paint: along the stroke from "
                   "left to right, across it from top to bottom.",
           .is_path = true,
           .matters_when = "brush = image"}),
      field<&StrokeParams::brush_length>({.name = "brush_length",
                                          .help = "Of one repetition of the paint along the stroke.",
                                          .unit = "px",
                                          .limits = {1, 10000},
                                          .slider = {8, 512},
                                          .scale = Scale::log,
                                          .matters_when = "brush != solid"}),
      field<&StrokeParams::brush_fit>(
          {.name = "brush_fit",
           .help = "tile: repeated along the stroke; stretch: once from its start to its end.",
           .matters_when = "brush != solid"}),
      field<&StrokeParams::grain>({.name = "grain",
                                   .help = "How much of the stroke's paint the brush leaves out.",
                                   .limits = {0, 1},
                                   .matters_when = "brush != solid"}),
      field<&StrokeParams::coherent>(
          {.name = "coherent", .help = "In films paint stays where it was on the line in the frame before."}),
  };
}

std::vector<Field> hidden_fields() {
  return {
      field<&StrokeParams::hidden>({.name = "hidden", .help = "Draw what surfaces cover, dashed."}),
      field<&StrokeParams::hidden_width>({.name = "hidden_width",
                                          .help = "Times the width, of covered strokes.",
                                          .limits = {0, 100},
                                          .slider = {0, 2},
                                          .matters_when = "hidden = true"}),
      field<&StrokeParams::hidden_opacity>({.name = "hidden_opacity",
                                            .help = "Times the opacity, of covered strokes.",
                                            .limits = {0, 1},
                                            .matters_when = "hidden = true"}),
      field<&StrokeParams::dash>({.name = "dash",
                                  .help = "Length of a dash.",
                                  .unit = "px",
                                  .limits = {0.5, 1000},
                                  .slider = {1, 30},
                                  .matters_when = "hidden = true"}),
      field<&StrokeParams::dash_gap>({.name = "dash_gap",
                                      .help = "Length between dashes; 0: covered strokes are not dashed.",
                                      .unit = "px",
                                      .limits = {0, 1000},
                                      .slider = {0, 30},
                                      .matters_when = "hidden = true"}),
  };
}

Description make_stroke() {
  Description description{"stroke", "Strokes", {}, {}};
  for (const auto& fields : {width_fields(), course_fields(), paint_fields(), hidden_fields()})
    description.fields.insert(description.fields.end(), fields.begin(), fields.end());
  return description;
}

}  // namespace

const Description& StrokeParams::description() {
  static const Description kDescription = make_stroke();
  return kDescription;
}

StrokeClasses default_stroke_classes() {
  // Okabe and Ito's palette, and darker ones of its hues for what it has no colour for.
  constexpr std::array<glm::vec3, kCurveClasses> kColours{{{0.0F, 0.0F, 0.0F},
                                                           {0.902F, 0.624F, 0.0F},
                                                           {0.35F, 0.35F, 0.35F},
                                                           {0.0F, 0.447F, 0.698F},
                                                           {0.835F, 0.369F, 0.0F},
                                                           {0.0F, 0.62F, 0.451F},
                                                           {0.8F, 0.475F, 0.655F},
                                                           {0.337F, 0.706F, 0.914F},
                                                           {0.5F, 0.2F, 0.6F},
                                                           {0.0F, 0.4F, 0.3F},
                                                           {0.55F, 0.45F, 0.2F},
                                                           {0.6F, 0.25F, 0.15F}}};
  StrokeClasses classes;
  for (size_t i = 0; i < kCurveClasses; ++i) classes[i].colour = kColours[i];
  return classes;
}

const Description& StrokeClassParams::description() {
  static const Description kDescription{
      "stroke_class",
      "Strokes of one class",
      {
          field<&StrokeClassParams::width>({.name = "width",
                                            .help = "Times stroke.width; 0 draws none of them.",
                                            .limits = {0, 100},
                                            .slider = {0, 4}}),
          colour_field<&StrokeClassParams::colour>(
              {.name = "colour",
               .help = "Their colour, in the buffer curves and where strokes are coloured by class."}),
          field<&StrokeClassParams::opacity>(
              {.name = "opacity", .help = "Times stroke.opacity.", .limits = {0, 1}}),
      },
      ""};
  return kDescription;
}

std::vector<ProfilePoint> parse_profile(std::string_view text, const std::string& where) {
  const auto refuse = [&] {
    return input_error(where, "is no profile: " + printable(text),
                       "give pairs of a place and a share, both 0 to 1, in order, such as 0 0.2, 0.5 1, 1 0");
  };
  std::vector<ProfilePoint> profile;
  if (trim(text).empty()) return profile;
  for (const std::string& pair : split(text, ',')) {
    const std::string_view trimmed = trim(pair);
    ProfilePoint point;
    const char* const end = trimmed.data() + trimmed.size();
    const auto along = std::from_chars(trimmed.data(), end, point.along);
    if (along.ec != std::errc{} || along.ptr == end || *along.ptr != ' ') throw refuse();
    const std::string_view rest = trim({along.ptr, static_cast<size_t>(end - along.ptr)});
    const auto share = std::from_chars(rest.data(), rest.data() + rest.size(), point.share);
    if (share.ec != std::errc{} || share.ptr != rest.data() + rest.size()) throw refuse();
    const bool in_range =
        point.along >= 0.0F && point.along <= 1.0F && point.share >= 0.0F && point.share <= 1.0F;
    if (!in_range || (!profile.empty() && point.along < profile.back().along)) throw refuse();
    profile.push_back(point);
  }
  return profile;
}

std::string profile_text(const std::vector<ProfilePoint>& profile) {
  std::vector<std::string> pairs;
  for (const ProfilePoint& point : profile)
    pairs.push_back(shortest(point.along) + " " + shortest(point.share));
  return join(pairs, ", ");
}

}  // namespace inkbench
