// The panel of views: cameras kept by name and key, usual directions, fitting to scene and model.
#pragma once

#include <string>

#include "app/window/workbench.h"

namespace inkbench {

class ViewsPanel {
 public:
  /// Draws into the current ImGui window.
  void draw(Workbench& bench);

 private:
  void draw_bookmark(Workbench& bench, size_t index);
  void draw_bookmarks(Workbench& bench);
  void draw_name(Workbench& bench, size_t index, float width);

  std::string name_;
  int renamed_ = -1;  ///< The bookmark whose name is being typed.
  bool focus_ = false;
  std::string new_name_;
};

/// Keeps the camera under the digit 1 to 9, in place of the one that had it.
void keep_view(Workbench& bench, int key);
/// Back to the camera that has the digit; where none has, the log says so.
void recall_view(Workbench& bench, int key);

/// The camera farther or nearer so that all visible models, or the main one, fill the picture.
enum class FitTo { scene, model };
void fit_view(Workbench& bench, FitTo what);

}  // namespace inkbench
