// SPDX-License-Identifier: MIT
// A study before it runs, as a person fills it in: what to sweep, what to show, where it goes; or the text of
// a spec that is written by hand. In: the form and the settings as they are. Out: the spec, checked whole.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/sweep_builder.h"
#include "studies/sweep/spec.h"

namespace inkbench {

struct StudyForm {
  SweepRequest request;  ///< An empty title is made from the axes.
  int width_px = 0, height_px = 0;
  std::string name;              ///< Of the spec's file and the folder beside it; empty: made from the axes.
  std::filesystem::path folder;  ///< Where both go: it must be there, unless it is
  std::filesystem::path usual_folder;   ///< the one that is made where it is missing.
  std::optional<std::string> own_text;  ///< The spec as it was written by hand, instead of the request.
  std::filesystem::path source;         ///< The file that `own_text` came from; empty without one.

  bool operator==(const StudyForm&) const;
};

/// What would run.
struct CheckedForm {
  StudyDraft draft;               ///< The spec's text and where it is, or will be saved.
  std::filesystem::path out;      ///< The folder of the results.
  bool is_saved = false;          ///< The file is there with this very text.
  std::optional<StudySpec> spec;  ///< Nothing where it cannot run.
  std::string problem;            ///< Why not, with the text's line where it has one.
  std::string note;               ///< What to know before it runs; may be empty.
};

/// A form that sweeps nothing yet, with the settings' size.
StudyForm empty_form(const Settings& settings, const std::filesystem::path& folder);

/// The file's text as it is, or that of the study whose grid it is. Errors (input): it cannot be read, or is
/// no text.
StudyForm form_of_file(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Throws nothing for what is wrong with the form: that is its `problem`.
CheckedForm check_form(const StudyForm& form, const Settings& settings, const std::filesystem::path& scene);

/// Writes the spec, where it is not on the disk already. Errors (work): as `write_file_atomically`.
void save_form(const CheckedForm& form);

/// Every key that an axis can have, components included, in the order of the groups.
std::vector<std::string> sweepable_keys(const Settings& settings);

}  // namespace inkbench
