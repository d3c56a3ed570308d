// The grid of a study that runs or ran: looked at, measured by eye, and a cell's parameters taken over.
#pragma once

#include "app/panels/study_grid_view.h"
#include "app/window/thumbnails.h"
#include "app/window/workbench.h"

namespace inkbench {

class StudyResultsPanel {
 public:
  /// Draws into the current ImGui window.
  void draw(Workbench& bench);

 private:
  void follow_results(const Studies& studies);
  void draw_head(Workbench& bench, const ListedStudy& listed);
  void draw_choices(Workbench& bench, const StudyResults& results);
  void draw_cell_menu(Workbench& bench, const StudyResults& results, const GridMouse& mouse);
  void take_over(Workbench& bench, const StudyResults& results, size_t cell);

  Thumbnails thumbnails_;
  GridChoice choice_;
  std::filesystem::path folder_;  ///< That the choice is for.
  long revision_ = -1;
  std::optional<size_t> menu_cell_;
};

}  // namespace inkbench
