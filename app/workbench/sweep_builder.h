// SPDX-License-Identifier: MIT
// From "sweep this parameter" and "grid of these two" to a study's spec, which `inkbench study` runs
// unchanged. In: what to vary and the settings as they are. Out: TOML text whose cells have those very
// settings.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/buffers.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// What one axis of the grid varies: a range of a number or of one component of a vector, or listed values.
struct SweepAxis {
  std::string key;
  double from = 0, to = 0;
  int count = 5;
  Scale scale = Scale::linear;
  std::vector<Value> values;  ///< Where there are any, they are used instead of the range.
};

/// Whether `suggested_axis` has a range or values for it: numbers, components, true/false and choices.
bool can_sweep(const ConstParam& param);

/// A range around the present value, which is its middle as far as limits allow: a quarter to four times on a
/// log scale, a quarter of the slider's width to both sides on a linear one; the slider's range where that is
/// not possible; all values of a choice. Errors (input): an unknown key, or one that cannot be swept.
SweepAxis suggested_axis(const Settings& settings, const std::string& key);

struct SweepRequest {
  std::string title = "Sweep";
  std::vector<SweepAxis> axes;  ///< Columns, rows, pages: 1 to 3.
  std::vector<BufferName> show{BufferName::final};
  std::vector<std::string> measures;  ///< As in a spec; empty: none.
};

/// A spec and, where no scene file has the models and lights of the settings, a scene file to lie beside it.
struct StudyDraft {
  std::filesystem::path path, scene_path;
  std::string text, scene_text;  ///< `scene_text` is empty where no such file is needed.
};

/// The spec as it will lie at `path` (".../NAME.toml"). `scene` is the file that the settings started from,
/// or empty. Paths inside are relative to the project or to the spec where they lie below, else absolute.
/// Errors (input): no axis or more than three, two over the same parameter, a range that is empty, outside
/// the parameter's limits or not positive on a log scale, a count not from 1 to 1,000.
StudyDraft draft_study(const SweepRequest& request, const Settings& settings,
                       const std::filesystem::path& scene, const std::filesystem::path& path);

/// Writes the draft's file or files. Errors (work): as `write_file_atomically`.
void save_study(const StudyDraft& draft);

}  // namespace inkbench
