// SPDX-License-Identifier: MIT
// How the workbench window is laid out: sizes, dividers, open panels, theme. Described like a parameter
// group, so that the session file, its checks and menus are visitors over it.
#pragma once

#include <string>

#include "pipeline/params/description.h"

namespace inkbench {

enum class Theme { dark, light };
template <>
struct ChoiceNames<Theme> {
  static constexpr std::array<std::string_view, 2> names{"dark", "light"};
};

/// What the panel on the left shows.
enum class LeftTab { parameters, presets, history, views };
template <>
struct ChoiceNames<LeftTab> {
  static constexpr std::array<std::string_view, 4> names{"parameters", "presets", "history", "views"};
};

/// What the panel beside the pictures shows.
enum class SidePage { inspector, judge };
template <>
struct ChoiceNames<SidePage> {
  static constexpr std::array<std::string_view, 2> names{"inspector", "judge"};
};

/// Lines laid over all pictures.
enum class Overlay { none, reference, matches, causes };
template <>
struct ChoiceNames<Overlay> {
  static constexpr std::array<std::string_view, 4> names{"none", "reference", "matches", "causes"};
};

struct WindowLayout {
  int width_px = 1280;
  int height_px = 800;
  bool maximised = false;
  float left = 0.24F;
  float right = 0.21F;
  float bottom = 0.21F;
  bool show_parameters = true;
  bool show_inspector = true;
  bool show_timings = true;
  bool show_log = true;
  bool show_welcome = true;
  LeftTab left_tab = LeftTab::parameters;
  SidePage side_page = SidePage::inspector;
  Overlay overlay = Overlay::none;
  Theme theme = Theme::dark;
  float ui_scale = 0.0F;
  /// Of the detectors the chosen one's is shown alone.
  std::string open_groups = "mesh edges combine decaudin saito_takahashi mitchell laplacian dihedral ink";
  /// A first sheet leads from the scene to its lines; the others are a tick away.
  std::string hidden_buffers =
      "blinn_phong object_id visible_depth albedo material_id pair_angles pair_gaps coverage motion";

  static const Description& description();
  bool operator==(const WindowLayout&) const = default;
};

}  // namespace inkbench
