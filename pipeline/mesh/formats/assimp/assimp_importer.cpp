// SPDX-License-Identifier: MIT
// The module that holds Assimp: see scene_importer.h.
#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <set>
#include <string_view>

#include "pipeline/mesh/formats/assimp/file_access.h"
#include "pipeline/mesh/formats/assimp/node_places.h"
#include "pipeline/mesh/formats/assimp/part_soup.h"
#include "pipeline/mesh/formats/scene_importer.h"

namespace inkbench {
namespace {

std::string one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

/// "wheel", "wheel 2", "wheel 3".
std::string name_apart(const std::string& name, std::set<std::string>& taken) {
  std::string apart = name;
  for (int number = 2; !taken.insert(apart).second; ++number) apart = name + " " + std::to_string(number);
  return apart;
}

double displayed(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

class SceneReader {
 public:
  SceneReader(const aiScene& scene, bool is_gltf, bool cameras_are_known, ImportedScene& result)
      : scene_(scene), is_gltf_(is_gltf), cameras_are_known_(cameras_are_known), result_(result) {}

  void run() {
    for (const PlacedNode& node : nodes_) add_parts(node);
    if (!cameras_are_known_)
      result_.view_notes.push_back("Left out the cameras: orthographic ones are read from glTF files alone.");
    for (unsigned i = 0; i < scene_.mNumCameras && cameras_are_known_; ++i) add_camera(*scene_.mCameras[i]);
    for (unsigned i = 0; i < scene_.mNumLights; ++i) add_light(*scene_.mLights[i]);
  }

 private:
  void add_parts(const PlacedNode& placed_node) {
    const aiNode& node = *placed_node.node;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= scene_.mNumMeshes) continue;
      const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[i]];
      PolygonSoup soup = part_soup(mesh, placed_node.to_world, places_, is_gltf_);
      if (soup.corner_counts.empty()) continue;  // lines, points
      result_.parts.push_back(
          {name_apart(part_name(node, mesh), part_names_), std::move(soup), colour(mesh)});
    }
  }

  static std::string part_name(const aiNode& node, const aiMesh& mesh) {
    if (node.mName.length > 0) return node.mName.C_Str();
    return mesh.mName.length > 0 ? mesh.mName.C_Str() : "part";
  }

  glm::vec3 colour(const aiMesh& mesh) const {
    const glm::vec3 none = ImportedPart{}.colour;
    if (mesh.mMaterialIndex >= scene_.mNumMaterials) return none;
    const aiMaterial& material = *scene_.mMaterials[mesh.mMaterialIndex];
    aiColor4D found(0.0F, 0.0F, 0.0F, 1.0F);
    const bool is_base = material.Get(AI_MATKEY_BASE_COLOR, found) == aiReturn_SUCCESS;
    if (!is_base && material.Get(AI_MATKEY_COLOR_DIFFUSE, found) != aiReturn_SUCCESS) return none;
    glm::vec3 colour(found.r, found.g, found.b);
    for (int i = 0; i < 3; ++i) {
      if (!(colour[i] >= 0.0F && colour[i] <= 1.0F)) colour[i] = colour[i] > 1.0F ? 1.0F : 0.0F;
      if (is_gltf_) colour[i] = static_cast<float>(displayed(colour[i]));
    }
    return colour;
  }

  glm::dmat4 place_of(const aiString& name) const {
    const auto place = places_.find(name.C_Str());
    return place == places_.end() ? nodes_.front().to_world : place->second;
  }

  /// 0 of a perspective camera. Assimp's width is half of what is seen. The scale of a camera's node counts
  /// for nothing (glTF 2.0, 3.10.2).
  static double orthographic_height(const aiCamera& camera) {
    const double width = 2.0 * std::abs(static_cast<double>(camera.mOrthographicWidth));
    return camera.mAspect > 0.0F ? width / static_cast<double>(camera.mAspect) : width;
  }

  /// A Collada camera without a name, of which Assimp knows nothing: it has the default angle, a quarter of
  /// pi, taken for degrees.
  static bool is_unread(const aiCamera& camera) {
    const double fov = glm::degrees(static_cast<double>(camera.mHorizontalFOV));
    return camera.mAspect == 0.0F && std::abs(fov - std::numbers::pi / 4.0) < 1e-6;
  }

  void add_camera(const aiCamera& camera) {
    if (is_unread(camera)) {
      result_.view_notes.push_back("Left out the camera '" + std::string(camera.mName.C_Str()) +
                                   "', which cannot be read.");
      return;
    }
    const glm::dmat4 place = place_of(camera.mName);
    // A glTF camera without an aspect fits any; Assimp takes 1 for its horizontal angle.
    const double aspect = camera.mAspect > 0.0F ? camera.mAspect : (is_gltf_ ? 1.0 : 0.0);
    // It stands at its node; Assimp repeats the node's translation as its position.
    const aiVector3D position = is_gltf_ ? aiVector3D() : camera.mPosition;
    result_.cameras.push_back({camera.mName.C_Str(), placed(place, position), turned(place, camera.mLookAt),
                               turned(place, camera.mUp),
                               glm::degrees(static_cast<double>(camera.mHorizontalFOV)), aspect,
                               orthographic_height(camera)});
  }

  void add_light(const aiLight& light) {
    const glm::dmat4 place = place_of(light.mName);
    const std::string name = light.mName.C_Str();
    if (light.mType == aiLightSource_AMBIENT || light.mType == aiLightSource_UNDEFINED) {
      result_.view_notes.push_back("Left out the light '" + name +
                                   "', which has neither place nor direction.");
      return;
    }
    const bool is_directional = light.mType == aiLightSource_DIRECTIONAL;
    if (!is_directional && light.mType != aiLightSource_POINT)
      result_.view_notes.push_back("The light '" + name +
                                   "' shines all around: cones and areas are not drawn.");
    const aiColor3D& colour = light.mColorDiffuse;
    result_.lights.push_back({name,
                              is_directional ? ImportedLightType::directional : ImportedLightType::point,
                              placed(place, light.mPosition),
                              -turned(place, light.mDirection),
                              {colour.r, colour.g, colour.b}});
  }

  const aiScene& scene_;
  bool is_gltf_;
  bool cameras_are_known_;
  ImportedScene& result_;
  std::vector<PlacedNode> nodes_ = place_nodes(scene_);
  NodePlaces places_ = places_by_name(nodes_);
  std::set<std::string> part_names_;
};

/// Assimp gives a Collada file's orthographic camera as a perspective one, its size as an angle, and only its
/// log says so.
class CameraWarning : public Assimp::LogStream {
 public:
  explicit CameraWarning(bool& given) : given_(given) {}
  void write(const char* message) override {
    if (std::string_view(message).find("Orthographic cameras are not supported") != std::string_view::npos)
      given_ = true;
  }

 private:
  bool& given_;
};

bool is_gltf(const std::string& path) {
  std::string ending = path.substr(std::min(path.rfind('.'), path.size()));
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".gltf" || ending == ".glb" || ending == ".vrm";
}

bool read(const std::string& path, ImportedScene& scene, std::string& problem) {
  Assimp::Importer importer;
  importer.SetIOHandler(new FileAccess);  // which it owns
  bool cameras_are_wrong = false;
  Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
  Assimp::DefaultLogger::get()->attachStream(new CameraWarning(cameras_are_wrong), Assimp::Logger::Warn);
  const aiScene* const read = importer.ReadFile(path, 0);
  Assimp::DefaultLogger::kill();  // with the stream
  if (read == nullptr || read->mRootNode == nullptr) {
    problem = one_line(importer.GetErrorString());
    return false;
  }
  SceneReader(*read, is_gltf(path), !cameras_are_wrong, scene).run();
  return true;
}

constexpr SceneImporter kImporter{read};

}  // namespace
}  // namespace inkbench

extern "C" __attribute__((visibility("default"))) const inkbench::SceneImporter* inkbench_scene_importer() {
  return &inkbench::kImporter;
}
