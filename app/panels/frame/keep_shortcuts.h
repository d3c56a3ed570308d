// SPDX-License-Identifier: MIT
// The keys of what is kept: undo, files, views.
#pragma once

#include "app/window/keeping.h"
#include "app/window/pictures.h"
#include "app/window/view_state.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/file_opener.h"
#include "app/workbench/problems.h"

namespace inkbench {

class KeepShortcuts {
 public:
  /// All must outlive it.
  KeepShortcuts(Document& document, Pictures& pictures, ViewState& view, FileOpener& files, Keeping& keeping,
                Problems& problems, WantedDialog& wanted_dialog)
      : document_(document),
        pictures_(pictures),
        view_(view),
        files_(files),
        keeping_(keeping),
        problems_(problems),
        wanted_dialog_(wanted_dialog) {}

  /// Once a frame, before the other keys. `pictures_shown`: keys may act on them; `is_covered`: by the page
  /// of keys, so that they act on nothing but dialogs. Returns whether a key was one of these.
  bool handle(bool pictures_shown, bool is_covered);

 private:
  bool cancels_edit(bool popup);
  bool ask(FileDialog dialog);
  bool file_keys(bool shift);
  bool editing_keys(bool shift);
  bool view_keys(bool control, bool shift);

  Document& document_;
  Pictures& pictures_;
  ViewState& view_;
  FileOpener& files_;
  Keeping& keeping_;
  Problems& problems_;
  WantedDialog& wanted_dialog_;
};

}  // namespace inkbench
