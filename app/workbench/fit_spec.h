// SPDX-License-Identifier: MIT
// From the parameters that a person ticks to a search that `inkbench tune` runs unchanged. In: the settings
// as they are, what may move, the cameras to judge from. Out: the spec's text; whether what a search found is
// still about these settings.
#pragma once

#include <string>
#include <vector>

#include "pipeline/settings/settings.h"

namespace inkbench {

struct FitOptions {
  int budget = 200;               ///< Candidates at most.
  bool uses_kept_cameras = true;  ///< All that are kept, instead of the present one.

  static const Description& description();  ///< Of `budget`.
};

struct FitRequest {
  Settings settings;                  ///< What the search begins from.
  std::vector<std::string> keys;      ///< At least one, each as `can_fit` allows.
  std::vector<CameraParams> cameras;  ///< Judged together; none: the settings' own.
  int budget = 200;
};

/// Whether the parameter can be searched for, has an effect in these settings, and is no part of what the
/// lines are judged by: its value may move, the camera, the image and the judge stay.
bool can_fit(const Settings& settings, const std::string& key);

/// Those of the chosen method, and those beside its choice, in the order of the groups.
std::vector<std::string> usual_fit_keys(const Settings& settings);

/// Ticked before a person ticks anything: the method's numbers.
bool is_fitted_at_first(const Settings& settings, const std::string& key);

/// A scene file that can be read from any folder: what the search begins from.
std::string fit_scene_text(const FitRequest& request);

/// The spec, to lie beside a scene file of that name. Errors (input): no key, one that cannot be fitted.
std::string fit_spec_text(const FitRequest& request, const std::string& scene_name);

/// Whether what was found for the request still says something of these settings: nothing differs but the
/// fitted values, what the pictures are coloured with and, where it was judged from kept cameras, the camera.
bool is_still_about(const FitRequest& request, const Settings& settings);

}  // namespace inkbench
