// SPDX-License-Identifier: MIT
#include "pipeline/settings/model.h"

namespace inkbench {

bool is_named_mesh(std::string_view mesh) {
  return mesh == kRabbit || mesh.starts_with(kPackagePrefix);
}

const Description& MaterialParams::description() {
  static const Description kDescription{
      "material",
      "Material of a model (3.1)",
      {
          colour_field<&MaterialParams::colour>(
              {.name = "colour", .help = "Colour; multiplies the ambient and diffuse coefficients."}),
          field<&MaterialParams::ambient>(
              {.name = "ambient", .help = "Ambient coefficient.", .limits = {0, 10}, .slider = {0, 1}}),
          field<&MaterialParams::diffuse>(
              {.name = "diffuse", .help = "Diffuse coefficient.", .limits = {0, 10}, .slider = {0, 1}}),
          field<&MaterialParams::specular>(
              {.name = "specular",
               .help = "Specular coefficient; the highlight has the light's colour.",
               .limits = {0, 10},
               .slider = {0, 1}}),
          field<&MaterialParams::exponent>(
              {.name = "exponent",
               .help = "Specular exponent: larger is a smaller, sharper highlight.",
               .limits = {0.1, 10000},
               .slider = {1, 500},
               .scale = Scale::log}),
      }};
  return kDescription;
}

const Description& ModelParams::description() {
  static const Description kDescription{
      "model",
      "Models, each under its name",
      {
          field<&ModelParams::visible>({.name = "visible", .help = "Draw this model."}),
          field<&ModelParams::shape>({.name = "shape", .help = "A mesh from a file, or a built-in shape."}),
          field<&ModelParams::mesh>({.name = "mesh",
                                     .help = "Mesh file (OBJ, PLY, OFF, STL, glTF, FBX and more), or "
                                             "\"rabbit\" for Debian's bunny.obj, or a file of a Debian "
                                             "package: \"debian:libcgal-demo/fandisk.off\".",
                                     .is_path = true,
                                     .is_no_path = is_named_mesh,
                                     .matters_when = "shape = mesh"}),
          field<&ModelParams::part>(
              {.name = "part",
               .help =
                   "Only this part of a mesh file that has parts (glTF, FBX and more), by name or by number "
                   "from 1; all of them without it.",
               .matters_when = "shape = mesh"}),
          field<&ModelParams::segments>(
              {.name = "segments",
               .help = "Tessellation of a built-in shape; flat sides look the same at any.",
               .limits = {1, 1024},
               .slider = {1, 128},
               .scale = Scale::log,
               .matters_when = "shape != mesh"}),
          field<&ModelParams::fillet>({.name = "fillet",
                                       .help = "Radius of the rounded edges of a rounded box of side 1.",
                                       .limits = {0, 0.5},
                                       .matters_when = "shape = rounded_box"}),
          field<&ModelParams::tube>({.name = "tube",
                                     .help = "Tube radius of a torus of ring radius 1.",
                                     .limits = {0.01, 0.99},
                                     .matters_when = "shape = torus"}),
          field<&ModelParams::normals>({.name = "normals",
                                        .help = "The file's or shape's own, corner by corner (crease where "
                                                "it has none); sharp at creases; "
                                                "smooth across all edges; or flat."}),
          field<&ModelParams::smooth_angle>(
              {.name = "smooth_angle",
               .help = "Edges between faces that differ by less are smooth, unless the file says otherwise.",
               .unit = "deg",
               .limits = {0, 180}}),
          field<&ModelParams::orient>(
              {.name = "orient",
               .help = "Which way closed parts face: as the file has them, or outward.",
               .matters_when = "two_sided = false"}),
          field<&ModelParams::two_sided>(
              {.name = "two_sided",
               .help = "Light a face that is seen from behind as its front: for open surfaces and sheets."}),
          field<&ModelParams::size>(
              {.name = "size",
               .help = "Longest side of the bounding box; 0 keeps the mesh's own units.",
               .unit = "world units",
               .limits = {0, 1e6},
               .slider = {0, 10}}),
          field<&ModelParams::anchor>(
              {.name = "anchor",
               .help = "The point of the mesh that stands on position: its origin, or the "
                       "middle of its base."}),
          field<&ModelParams::position>({.name = "position",
                                         .help = "Where the anchor stands.",
                                         .unit = "world units",
                                         .limits = {-1e6, 1e6},
                                         .slider = {-10, 10}}),
          field<&ModelParams::rotation>({.name = "rotation",
                                         .help = "Turn about x, then y, then z.",
                                         .unit = "deg",
                                         .limits = {-360, 360},
                                         .slider = {-180, 180}}),
          field<&ModelParams::scale>({.name = "scale",
                                      .help = "Stretch along the model's own axes.",
                                      .limits = {1e-6, 1e6},
                                      .slider = {0.1, 10},
                                      .scale = Scale::log}),
      }};
  return kDescription;
}

}  // namespace inkbench
