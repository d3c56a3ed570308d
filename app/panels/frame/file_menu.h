// SPDX-License-Identifier: MIT
// The File menu: opening, recent files, scenes, saving, shaders.
#pragma once

#include "app/window/keeping.h"
#include "app/window/ui_map.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/file_opener.h"
#include "app/workbench/problems.h"

namespace inkbench {

class FileMenu {
 public:
  /// All must outlive it.
  FileMenu(Document& document, FileOpener& files, const Keeping& keeping, Problems& problems,
           WindowRequests& requests, WantedDialog& wanted_dialog, UiMap& ui_map)
      : document_(document),
        files_(files),
        keeping_(keeping),
        problems_(problems),
        requests_(requests),
        wanted_dialog_(wanted_dialog),
        ui_map_(ui_map) {}

  /// Between BeginMainMenuBar and EndMainMenuBar.
  void draw();

 private:
  void draw_recent();
  void draw_scenes();

  Document& document_;
  FileOpener& files_;
  const Keeping& keeping_;
  Problems& problems_;
  WindowRequests& requests_;
  WantedDialog& wanted_dialog_;
  UiMap& ui_map_;
};

}  // namespace inkbench
