// Everything that decides an image: the scene and each pass's parameters, as one value. All visitors (files,
// `--set`, studies, keys, tables) reach parameters through `list_params`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/params/param.h"
#include "pipeline/settings/camera.h"
#include "pipeline/settings/combine_params.h"
#include "pipeline/settings/display_params.h"
#include "pipeline/settings/image_params.h"
#include "pipeline/settings/ink_params.h"
#include "pipeline/settings/light.h"
#include "pipeline/settings/mesh_params.h"
#include "pipeline/settings/model.h"
#include "pipeline/settings/ramp.h"
#include "pipeline/settings/scene_params.h"

namespace inkbench {

struct Settings {
  ImageParams image;
  CameraParams camera;
  SceneParams scene;
  std::vector<LightParams> lights;
  std::vector<ModelParams> models;
  MeshParams mesh;
  RampParams ramp;
  CombineParams combine;
  InkParams ink;
  DisplayParams display;
};

/// All groups, in the order in which files and tables show them.
std::vector<ParamGroup> list_groups(Settings& settings);

/// All parameters, group by group.
std::vector<Param> list_params(Settings& settings);

/// The parameter of that key; `.x .y .z` or `.r .g .b` after a vector's key name a component.
/// Errors (input): unknown key, with the nearest valid one.
Param find_param(Settings& settings, const std::string& key, const std::string& where);
bool has_param(Settings& settings, const std::string& key);

/// Sets from TOML text of a value ("0.003", "[0, 1, 0]", "\"box\"", also bare words and "0, 1, 0"); relative
/// paths are taken from the working folder. Errors (input): as `Param::set`.
void set_param_text(Settings& settings, const std::string& key, const std::string& text,
                    const std::string& where);

/// "KEY=VALUE" as on a command line.
void apply_assignment(Settings& settings, const std::string& assignment);

/// What is wrong between parameters that are each valid (camera, names, light directions): throws an input
/// error.
void check_settings(const Settings& settings);

/// The model that `--mesh` replaces: the first one that is a mesh, else the first. Errors (input): no models.
ModelParams& main_model(Settings& settings);

/// `settings.mesh` for the main model, which it is about; the others are drawn as they are.
MeshParams level_of(const Settings& settings, size_t model);

/// Its place in `models`, or nothing where there are none.
std::optional<size_t> main_model_index(const Settings& settings);

}  // namespace inkbench
