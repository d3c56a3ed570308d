// SPDX-License-Identifier: MIT
// The grid and the charts of a study that runs or ran: looked at, measured by eye, and a cell's parameters
// taken over.
#pragma once

#include "app/panels/study/study_grid_view.h"
#include "app/window/studies.h"
#include "app/window/thumbnails.h"
#include "app/window/ui_map.h"
#include "app/window/window_requests.h"
#include "app/workbench/document.h"
#include "app/workbench/problems.h"

namespace inkbench {

class StudyResultsPanel {
 public:
  /// All must outlive it.
  StudyResultsPanel(Document& document, Studies& studies, Problems& problems, WindowRequests& requests,
                    UiMap& ui_map)
      : document_(document), studies_(studies), problems_(problems), requests_(requests), ui_map_(ui_map) {}

  /// Draws into the current ImGui window.
  void draw();

 private:
  void follow_results();
  void draw_head(const ListedStudy& listed);
  /// Returns whether the charts are chosen.
  bool draw_kinds(const StudyResults& results);
  void draw_choices(const StudyResults& results);
  void draw_zoom(float& zoom, float largest);
  void draw_grid(const StudyResults& results);
  void draw_cell_menu(const StudyResults& results, const GridMouse& mouse);
  void take_over(const StudyResults& results, size_t cell);

  Document& document_;
  Studies& studies_;
  Problems& problems_;
  WindowRequests& requests_;
  UiMap& ui_map_;
  Thumbnails thumbnails_;
  GridChoice choice_;
  bool wants_charts_ = false;
  float chart_zoom_ = 1.0F;
  std::filesystem::path folder_;  ///< That the choice is for.
  long revision_ = -1;
  std::optional<size_t> menu_cell_;
};

}  // namespace inkbench
