// SPDX-License-Identifier: MIT
// The panel of stroke styles: bundled ones, files of one's own, and the width along the stroke, drawn by
// hand. The pictures follow while it is drawn. It edits whatever parameter is such a profile.
#pragma once

#include <string>
#include <vector>

#include "app/panels/parameters/profile_canvas.h"
#include "app/panels/parameters/stroke_sample.h"
#include "app/panels/widgets/file_question.h"
#include "app/window/ui_map.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"
#include "pipeline/params/toml_document.h"

namespace inkbench {

class StyleEditor {
 public:
  /// All must outlive it.
  StyleEditor(Document& document, Problems& problems, UiMap& ui_map)
      : document_(document), problems_(problems), ui_map_(ui_map), question_(problems, ui_map) {}

  /// Draws into the current ImGui window.
  void draw();

 private:
  struct ListedStyle {
    std::string name, title;
    TomlNode parameters;
    bool is_on = false;  ///< The settings are as it sets them.
  };
  void list();
  void find_which_is_on();
  void take(const std::string& style, const std::string& step);
  void draw_styles(float width);
  void draw_files();
  void draw_profile(float width, float height);

  Document& document_;
  Problems& problems_;
  UiMap& ui_map_;
  FileQuestion question_;
  std::vector<ListedStyle> styles_;
  long compared_revision_ = -1;
  CanvasState canvas_;
  StrokeSample sample_;
};

}  // namespace inkbench
