// SPDX-License-Identifier: MIT
#include "pipeline/mesh/levels/model_mesh.h"

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>

#include "pipeline/mesh/corner_normals.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/formats/package_mesh.h"
#include "pipeline/mesh/shapes/primitives.h"

namespace inkbench {

std::filesystem::path mesh_path(const std::string& mesh) {
  if (mesh.starts_with(kPackagePrefix)) return find_package_mesh(mesh.substr(kPackagePrefix.size()));
  return mesh == kRabbit ? find_rabbit() : std::filesystem::path(mesh);
}

MeshOptions mesh_options(const ModelParams& model) {
  MeshOptions options{.use_file_normals = model.normals == ModelNormals::file,
                      .smooth_below_deg = model.smooth_angle,
                      .outwards = model.orient == Orient::outward};
  if (model.normals == ModelNormals::smooth) options.smooth_below_deg = 180.0;
  if (model.normals == ModelNormals::flat) options.smooth_below_deg = 0.0;
  return options;
}

namespace {

Mesh make_shape(const ModelParams& model) {
  switch (model.shape) {
    case Shape::mesh:
      break;
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

}  // namespace

Mesh make_model_mesh(const ModelParams& model) {
  const MeshOptions options = mesh_options(model);
  if (model.shape == Shape::mesh) return load_mesh_file(mesh_path(model.mesh), options, model.part);
  Mesh mesh = make_shape(model);
  if (!options.use_file_normals) recompute_normals(mesh, {options.smooth_below_deg, {}});
  return mesh;
}

glm::mat4 model_matrix(const ModelParams& model, const Bounds& bounds) {
  const glm::vec3 extent = bounds.high - bounds.low;
  const float longest = std::max({extent.x, extent.y, extent.z, 1e-20F});
  const float fit = model.size > 0.0F ? model.size / longest : static_cast<float>(bounds.unit);
  glm::vec3 anchor(-bounds.origin / bounds.unit);
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
