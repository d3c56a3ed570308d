// SPDX-License-Identifier: MIT
// All parts of the window's state. It stands at the top alone: panels are handed the parts that they use and
// do not know each other.
#pragma once

#include "app/window/fit_desk.h"
#include "app/window/keeping.h"
#include "app/window/studies.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/window/viewer.h"
#include "app/window/window.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/file_opener.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

struct Workbench {
  /// Starts with the session's settings; `kept` must outlive this. Otherwise as `Viewer`.
  Workbench(const Session& session, Keeping& kept);
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;
  ~Workbench();

  Keeping& keeping;
  WindowLayout layout;
  ViewState view;
  UiMap ui_map;
  WindowRequests requests;
  WantedDialog wanted_dialog;
  MessageLog log{wake_window};  ///< What is told beside the window is shown at once, too.
  Problems problems{log};
  Document document;
  Studies studies;
  FitDesk fit;
  News news;  ///< Of all that works beside the window.
  Viewer viewer;
  FileOpener files;

 private:
  FileTakers takers();
};

}  // namespace inkbench
