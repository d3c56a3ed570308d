// The panel of presets: save, load, replace, delete, and what differs between now and one of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/window/workbench.h"

namespace inkbench {

class PresetsPanel {
 public:
  /// Draws into the current ImGui window.
  void draw(Workbench& bench);

 private:
  enum class Question { none, replace, remove };

  void list_again(Workbench& bench);
  void select(Workbench& bench, const std::string& name);
  void draw_saving(Workbench& bench);
  void draw_list(Workbench& bench, float height);
  void draw_actions(Workbench& bench);
  void draw_question(Workbench& bench);
  void draw_comparison(Workbench& bench);
  void save(Workbench& bench, const std::string& name, bool overwrite);
  void remove(Workbench& bench);

  std::string name_, selected_;
  std::vector<std::string> names_;
  std::optional<Settings> settings_;  ///< Of the selected one; none where it cannot be read.
  std::string fault_;                 ///< Why not.
  Question question_ = Question::none;
  int frames_to_listing_ = 0;
  PresetTable table_;
  long compared_revision_ = -1;
};

}  // namespace inkbench
