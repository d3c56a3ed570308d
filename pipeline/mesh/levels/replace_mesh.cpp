// SPDX-License-Identifier: MIT
#include "pipeline/mesh/levels/replace_mesh.h"

#include <algorithm>

#include "pipeline/mesh/levels/model_mesh.h"

namespace inkbench {

void replace_main_mesh(Settings& settings, const std::filesystem::path& mesh) {
  ModelParams& model = main_model(settings);
  if (model.size <= 0.0F || model.anchor != Anchor::base) {
    const Bounds bounds = bounds_of(make_model_mesh(model));
    const glm::vec3 extent = bounds.high - bounds.low;
    const glm::vec3 base{(bounds.low.x + bounds.high.x) / 2, bounds.low.y,
                         (bounds.low.z + bounds.high.z) / 2};
    const glm::vec3 place(model_matrix(model, bounds) * glm::vec4(base, 1.0F));
    const float size = model.size > 0.0F ? model.size : std::max({extent.x, extent.y, extent.z});
    const std::string where = "replacing the mesh of model '" + model.name + "'";
    find_param(settings, "model." + model.name + ".position", where).set(place, where);
    find_param(settings, "model." + model.name + ".size", where).set(size, where);
    model.anchor = Anchor::base;
  }
  model.shape = Shape::mesh;
  model.part.clear();
  // What was said of the old mesh's surface does not hold for the new one.
  const ModelParams fresh;
  model.normals = fresh.normals;
  model.smooth_angle = fresh.smooth_angle;
  model.orient = fresh.orient;
  model.two_sided = fresh.two_sided;
  model.mesh = is_named_mesh(mesh.string()) ? mesh.string()
                                            : std::filesystem::absolute(mesh).lexically_normal().string();
}

}  // namespace inkbench
