// SPDX-License-Identifier: MIT
// From the parameters that a person ticks to a search that `inkbench tune` runs unchanged. In: the settings
// as they are, what may move, the cameras to judge from. Out: the spec's text; whether what a search found is
// still about these settings.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/workbench/painted_marks.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

struct FitOptions {
  int budget = 400;               ///< Candidates at most.
  bool uses_kept_cameras = true;  ///< All that are kept, instead of the present one.
  bool uses_marks = true;         ///< Where there are some; else the reference lines alone.
  bool uses_reference = true;     ///< Beside marks.

  static const Description& description();  ///< Of `budget`.
};

struct FitRequest {
  Settings settings;                  ///< What the search begins from.
  std::vector<std::string> keys;      ///< At least one, each as `can_fit` allows.
  std::vector<CameraParams> cameras;  ///< Judged together; none: the settings' own.
  int budget = 400;
  PaintedMarks marks;  ///< That are to be complied with; those of other sizes than the image's do not count.
  bool uses_reference = true;  ///< Beside marks.
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

/// The marks that a fit can look at: those of the image's size, where the options want them.
PaintedMarks fit_marks(const Settings& settings, const PaintedMarks& marks, const FitOptions& options);

/// Those to judge from: the kept ones or, where none are wanted, the present one, with those that have marks;
/// marks alone are judged from their own cameras. Empty where it is the present one alone.
std::vector<CameraParams> fit_cameras(const Settings& settings, std::span<const CameraParams> kept,
                                      const PaintedMarks& marks, const FitOptions& options);

/// What a spec with marks says besides; their files are written into its folder. "" without marks. Errors
/// (work): as `write_marks`.
std::string write_fit_marks(const std::filesystem::path& folder, const FitRequest& request);

/// The spec, to lie beside a scene file of that name. Errors (input): no key, one that cannot be fitted.
std::string fit_spec_text(const FitRequest& request, const std::string& scene_name);

/// Whether what was found for the request still says something of these settings: nothing differs but the
/// fitted values, what the pictures are coloured with and, where it was judged from kept cameras, the camera.
bool is_still_about(const FitRequest& request, const Settings& settings);

}  // namespace inkbench
