// SPDX-License-Identifier: MIT
// A model: a mesh file or a built-in shape, where it stands, and its material.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "pipeline/params/description.h"

namespace inkbench {

enum class Shape { mesh, box, rounded_box, sphere, inside_out_sphere, torus, plane };
template <>
struct ChoiceNames<Shape> {
  static constexpr std::array<std::string_view, 7> names{
      "mesh", "box", "rounded_box", "sphere", "inside_out_sphere", "torus", "plane"};
};

/// What `mesh` names instead of a file: bunny.obj of Debian's package glmark2-data.
inline constexpr std::string_view kRabbit = "rabbit";
/// And what begins the name of a file that a Debian package brings: "debian:libcgal-demo/fandisk.off".
inline constexpr std::string_view kPackagePrefix = "debian:";
bool is_named_mesh(std::string_view mesh);

/// The point of the mesh that stands on `position`.
enum class Anchor { origin, base };
template <>
struct ChoiceNames<Anchor> {
  static constexpr std::array<std::string_view, 2> names{"origin", "base"};
};

/// Where the normals come from that light and the normal map see. `file`: from the file (or the built-in
/// shape), corner by corner; where it has none, as `crease`. `crease`: smooth across edges of less than
/// `smooth_angle`, sharp at the others. `smooth`: across all edges. `flat`: each face its own.
enum class ModelNormals { file, crease, smooth, flat };
template <>
struct ChoiceNames<ModelNormals> {
  static constexpr std::array<std::string_view, 4> names{"file", "crease", "smooth", "flat"};
};

/// Which way closed parts face: as the file has them, or outwards.
enum class Orient { file, outward };
template <>
struct ChoiceNames<Orient> {
  static constexpr std::array<std::string_view, 2> names{"file", "outward"};
};

/// Material coefficients of 3.1.
struct MaterialParams {
  glm::vec3 colour{0.8F};
  float ambient = 1.0F;
  float diffuse = 1.0F;
  float specular = 0.0F;
  float exponent = 32.0F;

  static const Description& description();
};

/// As many models as a scene can list: parameters are looked up by name among all.
inline constexpr size_t kMaxModels = 4096;

struct ModelParams {
  std::string name;
  bool visible = true;
  Shape shape = Shape::mesh;
  std::string mesh{kRabbit};
  std::string part;
  int segments = 32;
  float fillet = 0.1F;
  float tube = 0.35F;
  ModelNormals normals = ModelNormals::file;
  float smooth_angle = 40.0F;
  Orient orient = Orient::file;
  bool two_sided = true;
  float size = 0.0F;
  Anchor anchor = Anchor::origin;
  glm::vec3 position{0.0F};
  glm::vec3 rotation{0.0F};
  glm::vec3 scale{1.0F};
  MaterialParams material;

  static const Description& description();
};

}  // namespace inkbench
