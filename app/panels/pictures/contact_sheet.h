// SPDX-License-Identifier: MIT
// The middle of the window: all buffers side by side, one that fills it, or two compared.
#pragma once

#include "app/panels/pictures/picture_tile.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/window/viewer.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

class ContactSheet {
 public:
  /// All must outlive it.
  ContactSheet(Document& document, Viewer& viewer, const WindowLayout& layout, ViewState& view,
               Problems& problems, WantedDialog& wanted_dialog, UiMap& ui_map)
      : document_(document),
        viewer_(viewer),
        layout_(layout),
        view_(view),
        problems_(problems),
        wanted_dialog_(wanted_dialog),
        ui_map_(ui_map) {}

  /// Draws into the current ImGui window.
  void draw();

 private:
  void draw_tile(BufferName buffer, const TileRect& picture);
  void draw_sheet(ImVec2 low, ImVec2 room);

  Document& document_;
  Viewer& viewer_;
  const WindowLayout& layout_;
  ViewState& view_;
  Problems& problems_;
  WantedDialog& wanted_dialog_;
  UiMap& ui_map_;
};

}  // namespace inkbench
