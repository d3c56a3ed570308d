#include "app/panels/frame/menu_bar.h"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "app/panels/frame/edit_menu.h"
#include "app/panels/frame/shaders_menu.h"
#include "app/panels/frame/shortcuts.h"
#include "app/panels/pictures/comparison.h"
#include "app/panels/pictures/views_panel.h"
#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"
#include "app/workbench/open_outside.h"
#include "pipeline/base/files.h"

namespace inkbench {
namespace {

/// The scenes that come with the program, by name.
std::vector<fs::path> bundled_scenes() {
  std::vector<fs::path> scenes;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(project_file("data/scenes"), error)) {
    if (entry.path().extension() == ".toml") scenes.push_back(entry.path());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

}  // namespace

void MenuBar::file_menu(Workbench& bench) {
  const bool open = ImGui::BeginMenu("File");
  bench.ui_map.mark_item("menu:File");
  if (!open) return;
  draw_file_items(bench);
  const bool scenes = ImGui::BeginMenu("Scenes");
  bench.ui_map.mark_item("menu:Scenes");
  if (scenes) {
    for (const fs::path& scene : bundled_scenes()) {
      if (menu_item(bench.ui_map, scene.stem().c_str())) bench.open(scene.string());
    }
    ImGui::EndMenu();
  }
  ImGui::Separator();
  shaders_menu(bench);
  ImGui::Separator();
  if (menu_item(bench.ui_map, "Quit", "Ctrl+Q")) bench.requests.close = true;
  ImGui::EndMenu();
}

void MenuBar::view_menu(Workbench& bench) {
  WindowLayout& layout = bench.layout;
  const bool open = ImGui::BeginMenu("View");
  bench.ui_map.mark_item("menu:View");
  if (!open) return;
  const auto panel = [&](const char* label, bool& shown) {
    if (menu_item(bench.ui_map, label, nullptr, shown)) shown = !shown;
  };
  panel("Left panel", layout.show_parameters);
  panel("Inspector", layout.show_inspector);
  panel("Timings", layout.show_timings);
  panel("Log", layout.show_log);
  if (menu_item(bench.ui_map, "Ramp editor", "R", bench.view.edits_ramps))
    bench.view.edits_ramps = !bench.view.edits_ramps;
  ImGui::Separator();
  if (menu_item(bench.ui_map, "Pin this state", "P")) pin_state(bench);
  if (menu_item(bench.ui_map, "Compare", "C", bench.view.comparison.active)) toggle_comparison(bench);
  if (menu_item(bench.ui_map, "Wireframe", "W", bench.view.wireframe))
    bench.view.wireframe = !bench.view.wireframe;
  if (menu_item(bench.ui_map, "Fit the scene", "Home")) fit_view(bench, FitTo::scene);
  ImGui::Separator();
  if (menu_item(bench.ui_map, "Pictures as they are", "L", layout.overlay == Overlay::none))
    layout.overlay = Overlay::none;
  if (menu_item(bench.ui_map, "Reference lines over them", "L", layout.overlay == Overlay::reference))
    layout.overlay = Overlay::reference;
  if (menu_item(bench.ui_map, "Right and wrong lines", "L", layout.overlay == Overlay::matches))
    layout.overlay = Overlay::matches;
  ImGui::Separator();
  if (menu_item(bench.ui_map, "Dark", nullptr, layout.theme == Theme::dark)) layout.theme = Theme::dark;
  if (menu_item(bench.ui_map, "Light", nullptr, layout.theme == Theme::light)) layout.theme = Theme::light;
  ImGui::Separator();
  if (menu_item(bench.ui_map, "Larger text", "Ctrl++")) change_text_size(bench, 0.1F);
  if (menu_item(bench.ui_map, "Smaller text", "Ctrl+-")) change_text_size(bench, -0.1F);
  ImGui::Separator();
  if (menu_item(bench.ui_map, "Full screen", "F11")) bench.requests.toggle_full_screen = true;
  if (menu_item(bench.ui_map, "Save a screenshot", "F12")) bench.requests.screenshot = true;
  ImGui::EndMenu();
}

void MenuBar::draw(Workbench& bench) {
  if (ImGui::BeginMainMenuBar()) {
    height_ = ImGui::GetWindowHeight();
    file_menu(bench);
    draw_edit_menu(bench);
    view_menu(bench);
    studies_.draw_menu(bench);
    const bool help = ImGui::BeginMenu("Help");
    bench.ui_map.mark_item("menu:Help");
    if (help) {
      if (menu_item(bench.ui_map, "Keys and mouse", "F1")) bench.layout.show_welcome = true;
      if (menu_item(bench.ui_map, "Documentation"))
        attempt(bench, [] { open_outside(project_file("docs/workbench.md")); });
      ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
  }
  studies_.draw_question(bench);
}

}  // namespace inkbench
