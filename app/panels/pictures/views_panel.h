// SPDX-License-Identifier: MIT
// The panel of views: cameras kept by name and key, usual directions, fitting to scene and model.
#pragma once

#include <string>

#include "app/window/keeping.h"
#include "app/window/pictures.h"
#include "app/window/ui_map.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"

namespace inkbench {

class ViewsPanel {
 public:
  /// All must outlive it.
  ViewsPanel(Document& document, Pictures& pictures, Keeping& keeping, Problems& problems, UiMap& ui_map)
      : document_(document), pictures_(pictures), keeping_(keeping), problems_(problems), ui_map_(ui_map) {}

  /// Draws into the current ImGui window.
  void draw();

 private:
  void draw_bookmark(size_t index);
  void draw_bookmarks();
  void draw_name(size_t index, float width);

  Document& document_;
  Pictures& pictures_;
  Keeping& keeping_;
  Problems& problems_;
  UiMap& ui_map_;
  std::string name_;
  int renamed_ = -1;  ///< The bookmark whose name is being typed.
  bool focus_ = false;
  std::string new_name_;
};

/// Keeps the camera under the digit 1 to 9, in place of the one that had it.
void keep_view(const Document& document, Keeping& keeping, Problems& problems, int key);
/// Back to the camera that has the digit; where none has, the log says so.
void recall_view(Document& document, Keeping& keeping, Problems& problems, int key);

/// From perspective to orthographic or back: what is at the target keeps its size.
void toggle_projection(Document& document, Pictures& pictures, Problems& problems);

/// The camera farther or nearer so that all visible models, or the main one, fill the picture.
enum class FitTo { scene, model };
void fit_view(Document& document, Pictures& pictures, Problems& problems, FitTo what);

}  // namespace inkbench
