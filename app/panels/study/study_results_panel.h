// The grid and the charts of a study that runs or ran: looked at, measured by eye, and a cell's parameters
// taken over.
#pragma once

#include "app/panels/study/study_grid_view.h"
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
  /// Returns whether the charts are chosen.
  bool draw_kinds(Workbench& bench, const StudyResults& results);
  void draw_choices(Workbench& bench, const StudyResults& results);
  void draw_zoom(Workbench& bench, float& zoom, float largest);
  void draw_grid(Workbench& bench, const StudyResults& results);
  void draw_cell_menu(Workbench& bench, const StudyResults& results, const GridMouse& mouse);
  void take_over(Workbench& bench, const StudyResults& results, size_t cell);

  Thumbnails thumbnails_;
  GridChoice choice_;
  bool wants_charts_ = false;
  float chart_zoom_ = 1.0F;
  std::filesystem::path folder_;  ///< That the choice is for.
  long revision_ = -1;
  std::optional<size_t> menu_cell_;
};

}  // namespace inkbench
