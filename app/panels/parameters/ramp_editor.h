// SPDX-License-Identifier: MIT
// The panel that edits the lighting ramps by their stops; the pictures follow while a stop is dragged. It
// lists whatever parameters are ramps.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/panels/parameters/ramp_strip.h"
#include "app/panels/widgets/file_question.h"
#include "app/window/disk_watch.h"
#include "app/window/ui_map.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

class RampEditor {
 public:
  /// All must outlive it.
  RampEditor(Document& document, const DiskWatch& disk, const WindowLayout& layout, Problems& problems,
             UiMap& ui_map)
      : document_(document),
        disk_(disk),
        layout_(layout),
        problems_(problems),
        ui_map_(ui_map),
        question_(problems, ui_map) {}

  /// Draws into the current ImGui window.
  void draw();

 private:
  /// One ramp's colours, kept until it or a file on disk changes.
  struct Colours {
    Ramp ramp;
    long files_revision = -1;
    std::vector<glm::vec3> table;
    std::string problem;
  };
  struct Editor {
    StripState strip;
    Colours colours;
    std::optional<Ramp> before_bands;  ///< While the number of bands is dragged.
  };

  void draw_ramp(const std::string& key, const Field& field, const Ramp& ramp, float width);
  void title_row(const std::string& key, const Field& field, const Ramp& ramp, float width);
  void file_buttons(const std::string& key, const Ramp& ramp);
  void stop_colour(const std::string& key, const Ramp& ramp, bool opens);
  void stop_row(const std::string& key, const Ramp& ramp);

  Document& document_;
  const DiskWatch& disk_;
  const WindowLayout& layout_;
  Problems& problems_;
  UiMap& ui_map_;
  std::map<std::string, Editor> editors_;
  std::string last_;  ///< The ramp that the Delete key means.
  FileQuestion question_;
};

}  // namespace inkbench
