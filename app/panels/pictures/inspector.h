// The panel beside the pictures: the selected buffer, how it is shown, and each buffer's value under the
// mouse.
#pragma once

#include "app/panels/pictures/histogram_view.h"
#include "app/window/workbench.h"

namespace inkbench {

class InspectorPanel {
 public:
  void draw(Workbench& bench);

 private:
  void draw_pixel(Workbench& bench);

  HistogramView histogram_;
  std::optional<HoveredPixel> pixel_;  ///< The last one under the mouse.
};

}  // namespace inkbench
