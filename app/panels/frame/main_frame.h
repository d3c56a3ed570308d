// SPDX-License-Identifier: MIT
// The whole window: its panels, each made with the parts that it uses, where they are, the dividers between
// them, and each panel's turn.
#pragma once

#include "app/panels/frame/file_dialogs.h"
#include "app/panels/frame/file_menu.h"
#include "app/panels/frame/history_panel.h"
#include "app/panels/frame/keep_shortcuts.h"
#include "app/panels/frame/left_panel.h"
#include "app/panels/frame/log_panel.h"
#include "app/panels/frame/presets_panel.h"
#include "app/panels/frame/shortcuts.h"
#include "app/panels/frame/side_panel.h"
#include "app/panels/frame/view_menu.h"
#include "app/panels/judge/fit_panel.h"
#include "app/panels/judge/judge_view.h"
#include "app/panels/parameters/parameters.h"
#include "app/panels/parameters/ramp_editor.h"
#include "app/panels/parameters/style_editor.h"
#include "app/panels/pictures/contact_sheet.h"
#include "app/panels/pictures/inspector.h"
#include "app/panels/pictures/views_panel.h"
#include "app/panels/study/studies_menu.h"
#include "app/panels/study/studies_page.h"
#include "app/window/workbench.h"

namespace inkbench {

class MainFrame {
 public:
  /// `bench` must outlive it.
  explicit MainFrame(Workbench& bench);

  /// Between ImGui's NewFrame and Render.
  void draw();

 private:
  struct Places;
  Places arrange() const;
  ShownParts shown_parts() const;
  void draw_menu_bar();
  void draw_pictures();
  void draw_dividers(const Places& places);
  template <class Draw>
  void draw_editor(const Places& places, const char* heading, const char* close, const Draw& draw);
  void draw_bottom(const Places& places);

  Workbench& bench_;
  ParametersPanel parameters_;
  PresetsPanel presets_;
  HistoryPanel history_;
  ViewsPanel views_;
  LeftPanel left_;
  InspectorPanel inspector_;
  FitPanel fit_;
  JudgeView judge_;
  SidePanel side_panel_;
  ContactSheet sheet_;
  StudiesPage studies_;
  RampEditor ramp_editor_;
  StyleEditor style_editor_;
  LogPanel log_;
  FileMenu file_menu_;
  ViewMenu view_menu_;
  StudiesMenu studies_menu_;
  FileDialogs dialogs_;
  KeepShortcuts keep_shortcuts_;
  Shortcuts shortcuts_;
  float menu_height_ = 0;  ///< Of the bar, in pixels.
};

}  // namespace inkbench
