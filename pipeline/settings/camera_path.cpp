// SPDX-License-Identifier: MIT
#include "pipeline/settings/camera_path.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "pipeline/base/error.h"
#include "pipeline/params/toml_reader.h"
#include "pipeline/params/toml_value.h"

namespace inkbench {

const Description& CameraPath::description() {
  static const Description kDescription{
      "path",
      "Camera path",
      {
          field<&CameraPath::frames>({.name = "frames",
                                      .help = "Pictures along the path.",
                                      .limits = {2, 3600},
                                      .slider = {2, 360}}),
          field<&CameraPath::axis>({.name = "axis",
                                    .help = "The direction that the camera turns about, through its target.",
                                    .limits = {-1, 1}}),
          field<&CameraPath::degrees>(
              {.name = "degrees",
               .help = "The whole turn, which the frames share; 2 for each frame if it is left out.",
               .unit = "deg",
               .limits = {-7200, 7200},
               .slider = {-360, 360}}),
      }};
  return kDescription;
}

double degrees_at(const CameraPath& path, int frame) {
  return static_cast<double>(path.degrees) * frame / path.frames;
}

CameraParams camera_at(const CameraPath& path, const CameraParams& camera, int frame) {
  const double angle = glm::radians(degrees_at(path, frame));
  if (angle == 0.0) return camera;
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), angle, glm::normalize(glm::dvec3(path.axis))));
  const glm::dvec3 target(camera.target);
  CameraParams turned = camera;
  turned.eye = glm::vec3(target + turn * (glm::dvec3(camera.eye) - target));
  turned.up = glm::vec3(turn * glm::normalize(glm::dvec3(camera.up)));  // each part stays within 1
  return turned;
}

Settings settings_at(const CameraPath& path, const Settings& settings, int frame) {
  Settings turned = settings;
  turned.camera = camera_at(path, settings.camera, frame);
  // So that what an image says of its settings can be read again.
  for (const Field& field : CameraParams::description().fields)
    check_value(field, "camera." + std::string(field.name), field.get(&turned.camera),
                "frame " + std::to_string(frame) + " of the path");
  return turned;
}

CameraPath read_path(const TomlNode& table, const std::string& name) {
  const TomlReader toml(name);
  const Description& description = CameraPath::description();
  if (!table.is_table())
    throw input_error(toml.at(table), "path is " + table.kind_name(), "it must be a table: [path]");
  std::vector<std::string> known;
  for (const Field& field : description.fields) known.emplace_back(field.name);
  toml.check_keys(table, known);
  CameraPath path;
  for (const Field& field : description.fields) {
    const TomlNode* node = table.find(std::string(field.name));
    if (node == nullptr) continue;
    const Param param{"path." + std::string(field.name), &field, &path};
    param.set(value_from_toml(param, *node, toml.at(*node), ""), toml.at(*node));
  }
  if (glm::length(path.axis) < 1e-6F)
    throw input_error(toml.at(*table.find("axis")), "path.axis has no length",
                      "give a direction, such as [0, 1, 0]");
  if (table.find("degrees") == nullptr) path.degrees = static_cast<float>(kDegreesPerFrame * path.frames);
  return path;
}

}  // namespace inkbench
