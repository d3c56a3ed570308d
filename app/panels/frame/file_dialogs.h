// SPDX-License-Identifier: MIT
// What the File menu asks about files: opening one, saving the settings or a picture. Each does what the
// command line does with the same file.
#pragma once

#include "app/panels/widgets/file_chooser.h"
#include "app/window/keeping.h"
#include "app/window/pictures.h"
#include "app/window/ui_map.h"
#include "app/window/view_state.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/file_opener.h"
#include "app/workbench/problems.h"

namespace inkbench {

class FileDialogs {
 public:
  /// All must outlive it.
  FileDialogs(Document& document, Pictures& pictures, const ViewState& view, FileOpener& files,
              const Keeping& keeping, Problems& problems, WantedDialog& wanted_dialog, UiMap& ui_map)
      : document_(document),
        pictures_(pictures),
        view_(view),
        files_(files),
        keeping_(keeping),
        problems_(problems),
        wanted_dialog_(wanted_dialog),
        ui_map_(ui_map),
        chooser_(keeping, ui_map) {}

  /// Once a frame; begins what is wanted.
  void draw();

 private:
  void begin(FileDialog dialog);
  void draw_image_choice();
  void set_image_ending(std::string_view ending);
  void finish(const std::filesystem::path& path);

  Document& document_;
  Pictures& pictures_;
  const ViewState& view_;
  FileOpener& files_;
  const Keeping& keeping_;
  Problems& problems_;
  WantedDialog& wanted_dialog_;
  UiMap& ui_map_;
  FileChooser chooser_;
  FileDialog dialog_ = FileDialog::open;
  ComparedPicture picture_;             ///< To save.
  std::filesystem::path image_folder_;  ///< Where the last picture was saved.
};

/// Saves the settings to the file they came from where inkbench wrote it, else asks where.
void save_settings(Document& document, Problems& problems, WantedDialog& wanted_dialog);

}  // namespace inkbench
