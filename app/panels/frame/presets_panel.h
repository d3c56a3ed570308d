// SPDX-License-Identifier: MIT
// The panel of presets: save, load, replace, delete, and what differs between now and one of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/window/keeping.h"
#include "app/window/ui_map.h"
#include "app/workbench/document.h"
#include "app/workbench/file_opener.h"
#include "app/workbench/problems.h"

namespace inkbench {

class PresetsPanel {
 public:
  /// All must outlive it.
  PresetsPanel(const Document& document, FileOpener& files, Keeping& keeping, Problems& problems,
               UiMap& ui_map)
      : document_(document), files_(files), keeping_(keeping), problems_(problems), ui_map_(ui_map) {}

  /// Draws into the current ImGui window.
  void draw();

 private:
  enum class Question { none, replace, remove };

  void list_again();
  void select(const std::string& name);
  void draw_saving();
  void draw_list(float height);
  void draw_actions();
  void draw_question();
  void draw_comparison();
  void save(const std::string& name, bool overwrite);
  void remove();

  const Document& document_;
  FileOpener& files_;
  Keeping& keeping_;
  Problems& problems_;
  UiMap& ui_map_;
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
