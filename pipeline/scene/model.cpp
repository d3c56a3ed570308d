#include "pipeline/scene/model.h"

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>

#include "pipeline/mesh/mesh_file.h"
#include "pipeline/mesh/primitives.h"

namespace inkbench {

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
          field<&ModelParams::mesh>(
              {.name = "mesh",
               .help = "Mesh file (OBJ, PLY, OFF, STL), or \"rabbit\" for Debian's bunny.obj.",
               .is_path = true,
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
          field<&ModelParams::size>(
              {.name = "size",
               .help = "Longest side of the bounding box; 0 keeps the mesh's own units.",
               .unit = "world units",
               .limits = {0, 1e4},
               .slider = {0, 10}}),
          field<&ModelParams::anchor>(
              {.name = "anchor",
               .help = "The point of the mesh that stands on position: its origin, or the "
                       "middle of its base."}),
          field<&ModelParams::position>({.name = "position",
                                         .help = "Where the anchor stands.",
                                         .unit = "world units",
                                         .limits = {-1e4, 1e4},
                                         .slider = {-10, 10}}),
          field<&ModelParams::rotation>({.name = "rotation",
                                         .help = "Turn about x, then y, then z.",
                                         .unit = "deg",
                                         .limits = {-360, 360},
                                         .slider = {-180, 180}}),
          field<&ModelParams::scale>({.name = "scale",
                                      .help = "Stretch along the model's own axes.",
                                      .limits = {1e-4, 1e4},
                                      .slider = {0.1, 10},
                                      .scale = Scale::log}),
      }};
  return kDescription;
}

Mesh make_model_mesh(const ModelParams& model) {
  switch (model.shape) {
    case Shape::mesh:
      return load_mesh_file(model.mesh == "rabbit" ? find_rabbit() : std::filesystem::path(model.mesh));
    case Shape::box:
      return make_box(model.segments);
    case Shape::rounded_box:
      return make_rounded_box(model.segments, model.fillet);
    case Shape::sphere:
      return make_sphere(model.segments);
    case Shape::inside_out_sphere:
      return make_inside_out_sphere(model.segments);
    case Shape::torus:
      return make_torus(model.segments, model.tube);
    case Shape::plane:
      return make_plane(model.segments);
  }
  return {};
}

glm::mat4 model_matrix(const ModelParams& model, const Bounds& bounds) {
  const glm::vec3 extent = bounds.high - bounds.low;
  const float longest = std::max({extent.x, extent.y, extent.z, 1e-20F});
  const float fit = model.size > 0.0F ? model.size / longest : 1.0F;
  glm::vec3 anchor(0.0F);
  if (model.anchor == Anchor::base)
    anchor = {(bounds.low.x + bounds.high.x) / 2, bounds.low.y, (bounds.low.z + bounds.high.z) / 2};
  glm::mat4 matrix = glm::translate(glm::mat4(1.0F), model.position);
  matrix = glm::rotate(matrix, glm::radians(model.rotation.z), glm::vec3(0, 0, 1));
  matrix = glm::rotate(matrix, glm::radians(model.rotation.y), glm::vec3(0, 1, 0));
  matrix = glm::rotate(matrix, glm::radians(model.rotation.x), glm::vec3(1, 0, 0));
  matrix = glm::scale(matrix, model.scale * fit);
  return glm::translate(matrix, -anchor);
}

}  // namespace inkbench
