// The panel of parameters: every one that the descriptions list, by group, with a search box over all.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

class ParametersPanel {
 public:
  /// Draws into the current ImGui window.
  void draw(Workbench& bench);
  /// Puts the cursor into the search box.
  void focus_search() { focus_search_ = true; }

 private:
  void draw_search(Workbench& bench);
  void draw_nothing_found(Workbench& bench);
  /// Returns whether any of it is shown.
  bool draw_group(Workbench& bench, const ParamGroup& group, const ParamGroup* baseline);
  bool is_found(const std::string& key, const Field& field) const;

  std::string search_;
  bool only_changed_ = false;
  bool focus_search_ = false;
};

}  // namespace inkbench
