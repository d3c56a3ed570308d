// How often values occur in the selected buffer, with what is shown as black and as white: two marks to drag.
#pragma once

#include <imgui.h>

#include "app/window/workbench.h"
#include "app/workbench/value_histogram.h"

namespace inkbench {

class HistogramView {
 public:
  /// Draws into the current ImGui window.
  void draw(Workbench& bench, BufferName buffer);

 private:
  struct Axis {
    float low = 0.0F, high = 1.0F;
  };
  void refresh(Workbench& bench, const Frame& drawn, BufferName buffer);
  void draw_fields(Workbench& bench, BufferName buffer, const ShownRange& range);
  void drag_marks(Workbench& bench, BufferName buffer, const ShownRange& range, ImVec2 low, ImVec2 high);

  ValueHistogram histogram_;
  Key key_;
  BufferName buffer_ = BufferName::final;
  double took_ms_ = 0.0;
  bool log_ = true;
  Axis axis_;
  int dragged_ = -1;  ///< 0 black, 1 white.
};

/// What the buffer's picture shows as black and as white now.
ShownRange shown_range(Workbench& bench, BufferName buffer);

}  // namespace inkbench
