// SPDX-License-Identifier: MIT
// What differs between two settings, parameter by parameter, by visiting the descriptions. In: two settings.
// Out: a list of changes; what undo, the comparison of presets, sweeps and the command line are made from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/settings/settings.h"

namespace inkbench {

/// One parameter that differs. A side is empty where those settings have no model or light of that name.
struct ParamChange {
  std::string key;
  const Field* field = nullptr;  ///< Its description.
  std::optional<Value> before, after;

  bool operator==(const ParamChange&) const = default;
};

/// Whether both have the same models and the same lights, by name and in the same order.
bool same_structure(const Settings& a, const Settings& b);

/// The parameters that differ, in the order of files and tables; whole vectors, never components. Where the
/// structure differs, those that only `before` has come last.
std::vector<ParamChange> changed_params(const Settings& before, const Settings& after);

/// Same structure and no parameter differs.
bool same_settings(const Settings& a, const Settings& b);

/// Gives every changed parameter its value `after` (or `before`). The settings must have all of the keys.
/// Values are taken as they are: they were settings once.
void apply_changes(Settings& settings, const std::vector<ParamChange>& changes, bool forward = true);

/// A change for people: "combine.k_depth 0.003 -> 0.001", "camera.eye.x 2 -> 3".
std::string change_text(const ParamChange& change);

/// All of them in a few words: the one change; "camera.eye, target" or "camera (4 parameters)" where they are
/// of one group; else "5 parameters".
std::string changes_name(const std::vector<ParamChange>& changes);

/// The narrowest assignment that makes the change: the component's where only one of a vector's differs.
struct NarrowChange {
  std::string key;
  Value before, after;
};
/// Both sides must be there.
NarrowChange narrowed(const ParamChange& change);

}  // namespace inkbench
