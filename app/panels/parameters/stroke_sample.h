// SPDX-License-Identifier: MIT
// What a stroke of the present style looks like: its shape, without the grain of its paint.
#pragma once

#include <imgui.h>

#include <string>

#include "app/workbench/document.h"
#include "pipeline/strokes/stroke.h"

namespace inkbench {

class StrokeSample {
 public:
  /// Draws into the current ImGui window at the cursor; several times as large where strokes are thin.
  void draw(const Document& document, ImVec2 size);

 private:
  void make(const Settings& settings, ImVec2 size);

  Strokes strokes_;
  float times_ = 1.0F;   ///< How much larger it is shown.
  std::string problem_;  ///< Why there is none.
  long revision_ = -1;
  ImVec2 size_{};
};

}  // namespace inkbench
