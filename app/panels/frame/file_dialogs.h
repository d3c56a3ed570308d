// What the File menu asks about files: opening one, saving the settings or a picture. Each does what the
// command line does with the same file.
#pragma once

#include "app/panels/widgets/file_chooser.h"

namespace inkbench {

class FileDialogs {
 public:
  /// Once a frame; begins what `bench.wanted_dialog` asks for.
  void draw(Workbench& bench);

 private:
  void begin(Workbench& bench, FileDialog dialog);
  void draw_image_choice(Workbench& bench);
  void set_image_ending(std::string_view ending);
  void finish(Workbench& bench, std::filesystem::path path);

  FileChooser chooser_;
  FileDialog dialog_ = FileDialog::open;
  BufferName buffer_ = BufferName::final;
  std::filesystem::path image_folder_;  ///< Where the last picture was saved.
};

/// Saves the settings to the file they came from where inkbench wrote it, else asks where.
void save_settings(Workbench& bench);

}  // namespace inkbench
