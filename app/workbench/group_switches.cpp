// SPDX-License-Identifier: MIT
#include "app/workbench/group_switches.h"

#include <array>

#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

/// The paper's method with the numbers that it names.
void apply_papers(Settings& settings) {
  settings.edges = {};
  settings.combine = {};
}

/// The dihedral method with its defaults, and lines as they are drawn by default.
void apply_suggested(Settings& settings) {
  settings.edges = {};
  settings.edges.method = EdgeMethod::dihedral;
  settings.dihedral = {};
}

template <void (*kApply)(Settings&)>
bool is_applied(const Settings& settings) {
  Settings applied = settings;
  kApply(applied);
  return settings_text(applied) == settings_text(settings);
}

constexpr std::array kSwitches{
    GroupSwitch{"edges", "paper", "The paper's method with the paper's numbers.", "the paper's method",
                is_applied<apply_papers>, apply_papers},
    GroupSwitch{
        "edges", "suggested",
        "The dihedral method with its defaults: an angle in degrees and a gap in pixels, which mean the "
        "same at any size and in any scene.",
        "the suggested method", is_applied<apply_suggested>, apply_suggested},
};

}  // namespace

std::span<const GroupSwitch> group_switches() {
  return kSwitches;
}

}  // namespace inkbench
