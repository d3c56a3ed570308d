// SPDX-License-Identifier: MIT
// What a file of another program's scene holds, as far as it can be drawn here: parts in their places,
// cameras and lights. Everything is in the file's world, y up, in metres where the file says its unit. Pure
// data.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "pipeline/mesh/polygon_soup.h"

namespace inkbench {

/// One mesh at one node.
struct ImportedPart {
  std::string name;  ///< The node's or the mesh's; differs from all others of the file. UTF-8.
  PolygonSoup soup;
  glm::vec3 colour{0.8F};  ///< Of the material, as it is displayed, 0 to 1.
};

struct ImportedCamera {
  std::string name;
  glm::dvec3 eye{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};  ///< Of the view, of any length.
  glm::dvec3 up{0.0, 1.0, 0.0};
  double horizontal_fov_deg = 0.0;
  double aspect = 0.0;       ///< Width by height; 0 where the file does not say.
  double view_height = 0.0;  ///< Of what an orthographic camera shows; 0 of a perspective one.
};

enum class ImportedLightType { directional, point };

struct ImportedLight {
  std::string name;
  ImportedLightType type = ImportedLightType::directional;
  glm::dvec3 position{0.0};             ///< Of a point light.
  glm::dvec3 direction{0.0, 1.0, 0.0};  ///< Towards a directional light, of any length.
  glm::dvec3 intensity{1.0};            ///< In the file's unit; of a point light, at distance 1.
};

struct ImportedScene {
  std::vector<ImportedPart> parts;
  std::vector<ImportedCamera> cameras;
  std::vector<ImportedLight> lights;
  std::vector<std::string> notes;       ///< What became of the parts, one sentence each.
  std::vector<std::string> view_notes;  ///< Of cameras and lights.
};

}  // namespace inkbench
