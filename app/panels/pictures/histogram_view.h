// SPDX-License-Identifier: MIT
// How often values occur in the selected buffer, with what is shown as black and as white: two marks to drag.
#pragma once

#include <imgui.h>

#include "app/window/pictures.h"
#include "app/window/ui_map.h"
#include "app/window/viewer.h"
#include "app/workbench/document.h"
#include "app/workbench/value_histogram.h"

namespace inkbench {

class HistogramView {
 public:
  /// All must outlive it.
  HistogramView(const Document& document, Viewer& viewer, UiMap& ui_map)
      : document_(document), viewer_(viewer), ui_map_(ui_map) {}

  /// Draws into the current ImGui window.
  void draw(BufferName buffer);

 private:
  struct Axis {
    float low = 0.0F, high = 1.0F;
  };
  void refresh(const Frame& drawn, BufferName buffer);
  void draw_fields(BufferName buffer, const ShownRange& range);
  void drag_marks(BufferName buffer, const ShownRange& range, ImVec2 low, ImVec2 high);

  const Document& document_;
  Viewer& viewer_;
  UiMap& ui_map_;
  ValueHistogram histogram_;
  Key key_;
  BufferName buffer_ = BufferName::final;
  double took_ms_ = 0.0;
  bool log_ = true;
  Axis axis_;
  int dragged_ = -1;  ///< 0 black, 1 white.
};

/// What the buffer's picture shows as black and as white now.
ShownRange shown_range(const Document& document, Pictures& pictures, BufferName buffer);

}  // namespace inkbench
