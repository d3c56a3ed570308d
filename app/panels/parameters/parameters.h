// SPDX-License-Identifier: MIT
// The panel of parameters: every one that the descriptions list, by group, with a search box over all.
#pragma once

#include "app/window/fit_desk.h"
#include "app/window/studies.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

class ParametersPanel {
 public:
  /// All must outlive it.
  ParametersPanel(Document& document, WindowLayout& layout, ViewState& view, Studies& studies, FitDesk& fit,
                  Problems& problems, UiMap& ui_map)
      : document_(document),
        layout_(layout),
        view_(view),
        studies_(studies),
        fit_(fit),
        problems_(problems),
        ui_map_(ui_map) {}

  /// Draws into the current ImGui window.
  void draw();
  /// Puts the cursor into the search box.
  void focus_search() { focus_search_ = true; }

 private:
  void draw_search();
  void draw_nothing_found();
  /// Returns whether any of it is shown.
  void draw_switches(const Settings& settings, const std::string& group);
  bool draw_group(const Settings& settings, const ParamGroup& group, const ParamGroup* baseline);
  bool is_found(const std::string& key, const Field& field) const;

  Document& document_;
  WindowLayout& layout_;
  ViewState& view_;
  Studies& studies_;
  FitDesk& fit_;
  Problems& problems_;
  UiMap& ui_map_;
  std::string search_;
  bool only_changed_ = false;
  bool focus_search_ = false;
};

}  // namespace inkbench
