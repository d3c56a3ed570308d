// SPDX-License-Identifier: MIT
#include "tests/gl/scenes.h"

#include "pipeline/base/files.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

// So fine that the sphere is within 8e-5 of its radius of the exact one.
constexpr int kFine = 128;

RampParams mixed_ramps() {
  RampParams ramp;
  ramp.diffuse.stops = {{0.05F, {0.2F, 0.2F, 0.3F}, true},
                        {0.3F, {0.5F, 0.45F, 0.4F}, true},
                        {0.6F, {0.7F, 0.7F, 0.7F}, false},
                        {0.9F, {1.0F, 1.0F, 0.9F}, true}};
  ramp.specular.stops = {{0.0F, {0.0F, 0.0F, 0.0F}, true}, {0.5F, {0.6F, 0.8F, 1.0F}, true}};
  return ramp;
}

}  // namespace

Settings analytic_scene() {
  Settings settings;
  settings.image = {161, 117, Precision::float32};
  settings.camera = {{2.0F, 3.0F, 6.0F}, {0.2F, 0.5F, 0.0F}, {0.15F, 1.0F, 0.1F}, 40.0F, 0.1F, 20.0F};
  settings.scene = {{0.1F, 0.12F, 0.14F}, {0.9F, 0.8F, 0.7F}};
  settings.models = {{.name = "floor", .shape = Shape::plane, .segments = 1, .size = 5.0F},
                     {.name = "ball",
                      .shape = Shape::sphere,
                      .segments = kFine,
                      .size = 2.0F,
                      .anchor = Anchor::base,
                      .position = {0.9F, 0.0F, 0.0F}},
                     {.name = "box",
                      .shape = Shape::box,
                      .segments = 1,
                      .position = {-1.2F, 0.9F, 0.5F},
                      .rotation = {20.0F, 35.0F, 10.0F},
                      .scale = {1.0F, 1.3F, 0.8F}}};
  settings.models[0].material = {{0.7F, 0.6F, 0.5F}, 0.8F, 0.9F, 0.2F, 12.0F};
  settings.models[1].material = {{0.3F, 0.8F, 0.4F}, 1.0F, 0.7F, 0.5F, 40.0F};
  settings.models[2].material = {{0.4F, 0.5F, 0.9F}, 0.5F, 1.0F, 0.3F, 20.0F};
  LightParams sun{.name = "sun", .direction = {0.4F, 0.9F, 0.5F}};
  sun.ambient = {0.05F, 0.04F, 0.03F};
  sun.diffuse = {0.8F, 0.75F, 0.7F};
  sun.specular = {0.6F, 0.7F, 0.8F};
  LightParams lamp{.name = "lamp", .type = LightType::point, .position = {-1.5F, 3.0F, 3.0F}};
  lamp.ambient = {0.0F, 0.01F, 0.02F};
  lamp.diffuse = {0.3F, 0.2F, 0.4F};
  lamp.specular = {0.5F, 0.4F, 0.3F};
  settings.lights = {sun, lamp};
  settings.ramp = mixed_ramps();
  return settings;
}

Settings scaled_scene(Settings settings, float scale) {
  CameraParams& camera = settings.camera;
  for (float* const length : {&camera.near, &camera.far, &camera.view_height}) *length *= scale;
  for (glm::vec3* const place : {&camera.eye, &camera.target}) *place *= scale;
  for (LightParams& light : settings.lights) light.position *= scale;
  for (ModelParams& model : settings.models) {
    model.position *= scale;
    (model.size > 0.0F ? model.size : model.scale.x) *= scale;
    if (model.size > 0.0F) continue;
    model.scale.y *= scale;
    model.scale.z *= scale;
  }
  return settings;
}

Settings paper_scene(int width_px, int height_px) {
  Settings settings = load_settings(project_file("data/scenes/paper.toml"));
  settings.image.width = width_px;
  settings.image.height = height_px;
  return settings;
}

Settings small_scene() {
  Settings settings;
  settings.image.width = 48;
  settings.image.height = 40;
  settings.models = {{.name = "ball", .shape = Shape::sphere, .segments = 24, .size = 2.5F}};
  settings.models[0].material.specular = 0.5F;
  LightParams sun{.name = "sun", .direction = {0.4F, 0.9F, 0.5F}};
  settings.lights = {sun};
  return settings;
}

}  // namespace inkbench
