// The panel beside the pictures: the selected buffer, how it is shown, and each buffer's value under the
// mouse.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

class InspectorPanel {
 public:
  void draw(Workbench& bench);

 private:
  std::optional<HoveredPixel> pixel_;  ///< The last one under the mouse.
};

}  // namespace inkbench
