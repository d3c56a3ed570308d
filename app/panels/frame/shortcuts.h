// SPDX-License-Identifier: MIT
// What keys do, wherever the mouse is.
#pragma once

#include "app/panels/frame/keep_shortcuts.h"
#include "app/window/studies.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/window/viewer.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

/// What is there to see: keys act on nothing else.
struct ShownParts {
  bool pictures = true;  ///< Not behind the studies or the page of keys.
  bool left = true;      ///< The window has room for the left panel, whether it is shown or not,
  bool right = true;     ///< and for the right one.
};

/// What a key asks of panels.
struct ShortcutRequests {
  bool search = false;
};

class Shortcuts {
 public:
  /// All must outlive it. `keep` has its turn first.
  Shortcuts(KeepShortcuts& keep, const Document& document, Viewer& viewer, WindowLayout& layout,
            ViewState& view, Studies& studies, Problems& problems, WindowRequests& requests, UiMap& ui_map)
      : keep_(keep),
        document_(document),
        viewer_(viewer),
        layout_(layout),
        view_(view),
        studies_(studies),
        problems_(problems),
        requests_(requests),
        ui_map_(ui_map) {}

  /// Once a frame; keys that a text field wants are its own.
  ShortcutRequests handle(const ShownParts& shown);

 private:
  ShortcutRequests with_control(const ShownParts& shown);
  void function_keys();
  void step_back();
  void keys_of_pictures();
  void keys_of_panels(const ShownParts& shown);

  KeepShortcuts& keep_;
  const Document& document_;
  Viewer& viewer_;
  WindowLayout& layout_;
  ViewState& view_;
  Studies& studies_;
  Problems& problems_;
  WindowRequests& requests_;
  UiMap& ui_map_;
};

/// Larger or smaller by so many times the usual size.
void change_text_size(WindowLayout& layout, float change);

}  // namespace inkbench
