// SPDX-License-Identifier: MIT
// Everything that decides an image: the scene and each pass's parameters, as one value. All visitors (files,
// `--set`, studies, keys, tables) reach parameters through `list_params`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/params/condition.h"
#include "pipeline/params/param.h"
#include "pipeline/settings/brought_groups.h"
#include "pipeline/settings/camera.h"
#include "pipeline/settings/combine_params.h"
#include "pipeline/settings/curves_params.h"
#include "pipeline/settings/detector_params.h"
#include "pipeline/settings/dihedral_params.h"
#include "pipeline/settings/display_params.h"
#include "pipeline/settings/edges_params.h"
#include "pipeline/settings/image_params.h"
#include "pipeline/settings/ink_params.h"
#include "pipeline/settings/judge_params.h"
#include "pipeline/settings/light.h"
#include "pipeline/settings/line_params.h"
#include "pipeline/settings/mesh_params.h"
#include "pipeline/settings/model.h"
#include "pipeline/settings/ramp.h"
#include "pipeline/settings/scene_params.h"
#include "pipeline/settings/stroke_params.h"

namespace inkbench {

struct Settings {
  ImageParams image;
  CameraParams camera;
  SceneParams scene;
  std::vector<LightParams> lights;
  std::vector<ModelParams> models;
  MeshParams mesh;
  RampParams ramp;
  EdgesParams edges;
  CombineParams combine;
  DecaudinParams decaudin;
  SaitoTakahashiParams saito_takahashi;
  MitchellParams mitchell;
  LaplacianParams laplacian;
  DihedralParams dihedral;
  LineParams line;
  ClassLooks class_looks = default_class_looks();
  CurvesParams curves;
  StrokeParams stroke;
  StrokeClasses stroke_classes = default_stroke_classes();
  InkParams ink;
  DisplayParams display;
  JudgeParams judge;
  BroughtGroups brought;  ///< Of passes that bring a group of their own.
};

/// Calls `visit(prefix, group)` for every group, in the order in which files and tables show them; of models
/// and lights those for which `wanted("model" or "light", name)`. The one list of groups.
template <class AnySettings, class Visit, class Wanted>
void visit_groups(AnySettings& settings, const Visit& visit, const Wanted& wanted) {
  visit("image", settings.image);
  visit("camera", settings.camera);
  visit("scene", settings.scene);
  for (auto& model : settings.models) {
    if (!wanted("model", model.name)) continue;
    visit("model." + model.name, model);
    visit("model." + model.name + ".material", model.material);
  }
  visit("mesh", settings.mesh);
  for (auto& light : settings.lights) {
    if (wanted("light", light.name)) visit("light." + light.name, light);
  }
  visit("ramp", settings.ramp);
  visit("edges", settings.edges);
  visit("combine", settings.combine);
  visit("decaudin", settings.decaudin);
  visit("saito_takahashi", settings.saito_takahashi);
  visit("mitchell", settings.mitchell);
  visit("laplacian", settings.laplacian);
  visit("dihedral", settings.dihedral);
  visit("line", settings.line);
  for (size_t i = 0; i < kEdgeClasses; ++i)
    visit("line." + std::string(kEdgeClassNames[i + 1]), settings.class_looks[i]);
  visit("curves", settings.curves);
  visit("stroke", settings.stroke);
  for (size_t i = 0; i < kCurveClasses; ++i)
    visit("stroke." + std::string(kCurveClassNames[i]), settings.stroke_classes[i]);
  visit("ink", settings.ink);
  visit("display", settings.display);
  visit("judge", settings.judge);
}

/// All groups, in the order in which files and tables show them.
std::vector<ParamGroup> list_groups(Settings& settings);
std::vector<ConstParamGroup> list_groups(const Settings& settings);

/// All parameters, group by group.
std::vector<Param> list_params(Settings& settings);
std::vector<ConstParam> list_params(const Settings& settings);

/// The parameter of that key; `.x .y .z` or `.r .g .b` after a vector's key name a component.
/// Errors (input): unknown key, with the nearest valid one.
Param find_param(Settings& settings, const std::string& key, const std::string& where);
ConstParam find_param(const Settings& settings, const std::string& key, const std::string& where);
bool has_param(const Settings& settings, const std::string& key);

/// Whether the parameters, named by whole keys, are as all conditions say.
bool all_met(const Settings& settings, const std::vector<Condition>& conditions);

/// Whether the group's fields have an effect in these settings, by what its description says.
bool matters(const Settings& settings, const ConstParamGroup& group);
/// Whether this one has.
bool matters(const Settings& settings, const ConstParamGroup& group, const Field& field);

/// The conditions of a group's field, the group's own first, each with a whole key.
std::vector<Condition> conditions_of(const ConstParamGroup& group, const Field& field);

/// The canonical text of a described struct: what keys fold of it.
std::string group_text(const Description& description, const void* owner);
template <class Params>
std::string group_text(const Params& params) {
  return group_text(Params::description(), &params);
}

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
