// SPDX-License-Identifier: MIT
#include "app/window/disk_watch.h"

#include <utility>

#include "pipeline/base/error.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {

DiskWatch::DiskWatch(const Document& document, Problems& problems, Pipeline& pipeline, JudgeDesk& judge,
                     TilePainter& tiles, WirePainter& wires)
    : document_(document),
      problems_(problems),
      pipeline_(pipeline),
      judge_(judge),
      tiles_(tiles),
      wires_(wires) {}

/// What the files that the settings name hold, or why they cannot be read.
std::string DiskWatch::files_state() {
  try {
    return pipeline_.at(document_.settings()).key().text();
  } catch (const Error& error) {
    return error.what();
  }
}

/// Whether the files hold something else than at the last look, which must have been for the same settings:
/// what changed settings change is not a file's doing.
bool DiskWatch::take_files_state() {
  const std::string last_settings = std::exchange(files_settings_, settings_text(document_.settings()));
  const std::string last_state = std::exchange(files_state_, files_state());
  return last_settings == files_settings_ && last_state != files_state_;
}

/// Of all programs: mending one does not mend another.
std::string DiskWatch::shader_problem() const {
  for (const std::string& problem : {pipeline_.shader_problem(), judge_.shader_problem(),
                                     tiles_.shader_problem(), wires_.shader_problem()}) {
    if (!problem.empty()) return problem;
  }
  return "";
}

bool DiskWatch::reload_changed() {
  bool changed = pipeline_.reload_changed_shaders();
  changed |= judge_.reload_changed_shaders();
  changed |= tiles_.reload_if_changed();
  changed |= wires_.reload_if_changed();
  if (changed) judge_.causes.try_again();
  return changed;
}

bool DiskWatch::reload_shaders() {
  try {
    if (!reload_changed()) return false;
    problems_.tell(Severity::note, "shaders reloaded");
  } catch (const Error& error) {
    problems_.set(ProblemKind::shader, error.what());
    return true;
  }
  const std::string problem = shader_problem();
  if (problem.empty()) problems_.dismiss(ProblemKind::shader);
  if (!problem.empty()) problems_.set(ProblemKind::shader, problem);
  return true;
}

bool DiskWatch::poll() {
  const bool reloaded = reload_shaders();
  const bool changed = take_files_state() || reloaded;
  if (changed) ++revision_;
  return changed;
}

}  // namespace inkbench
