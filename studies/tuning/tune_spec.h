// SPDX-License-Identifier: MIT
// What a search is told: the pictures that it looks at, in groups; the parameters that it may move; what it
// wants. Read from TOML and checked whole.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "studies/sweep/spec.h"
#include "studies/tuning/mark_file.h"
#include "studies/tuning/tuner.h"

namespace inkbench {

/// One drawing of every candidate.
struct TunePicture {
  std::string name;  ///< "rabbit_front".
  size_t group = 0;
  std::vector<Assignment> set;
  std::string of_group, of_view;  ///< The [[group]] and [[view]] that it is of; "" where there are none.
  std::optional<MarkFile> marks;
};

struct TuneSpec {
  std::filesystem::path path;
  std::string text;  ///< The file's content.
  std::string title;
  std::string purpose;
  Settings base;
  SearchSpace space;
  Objective objective;
  std::vector<std::string> groups;    ///< What is left out in turn; at least one.
  std::string group_kind;             ///< "group" or "view": what a group is.
  std::vector<TunePicture> pictures;  ///< At least one in each group.
  bool has_marks() const;
  int budget = 400;
  uint64_t seed = 1;
  std::vector<std::string> assignments;  ///< `--set` texts that came on top.
};

/// The least budget: a look at the default, the paper's values and a few more.
inline constexpr int kLeastBudget = 10;
inline constexpr int kMostBudget = 1'000'000;

/// Errors (input): file:line for broken TOML, unknown keys, parameters that cannot be searched, ends that the
/// parameter does not accept, unknown measures, a budget out of range, a search without [[search]], marks of
/// no picture, marks files that cannot be read or have another size than their picture.
TuneSpec load_tune_spec(const std::filesystem::path& path, const std::vector<std::string>& assignments = {});
TuneSpec parse_tune_spec(const std::string& text, const std::filesystem::path& name,
                         const std::vector<std::string>& assignments = {});

/// A side over the parameter: its slider's range and scale, or all of its choices. Errors (input): text, a
/// ramp, a whole vector (one of its components can be searched), with `where`.
SearchAxis default_axis(const Settings& settings, const std::string& key, const std::string& where);

/// The picture's settings, the searched parameters as the base has them.
Settings picture_settings(const TuneSpec& spec, const TunePicture& picture);

/// The search by itself: what the scene has is the default; the paper's values of the searched parameters are
/// looked at, too.
TuneProblem problem_of(const TuneSpec& spec);

}  // namespace inkbench
