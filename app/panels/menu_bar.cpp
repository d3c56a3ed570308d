#include "app/panels/menu_bar.h"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "app/panels/edit_menu.h"
#include "app/window/theme.h"
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

bool item(Workbench& bench, const char* label, const char* keys = nullptr, bool on = false) {
  const bool chosen = ImGui::MenuItem(label, keys, on);
  bench.ui_map.mark_item(std::string("menu:") + label);
  return chosen;
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
      if (item(bench, scene.stem().c_str())) bench.open(scene.string());
    }
    ImGui::EndMenu();
  }
  ImGui::Separator();
  if (item(bench, "Quit", "Ctrl+Q")) bench.requests.close = true;
  ImGui::EndMenu();
}

void MenuBar::view_menu(Workbench& bench) {
  WindowParams& window = bench.window;
  const bool open = ImGui::BeginMenu("View");
  bench.ui_map.mark_item("menu:View");
  if (!open) return;
  if (item(bench, "Left panel", nullptr, window.show_left)) window.show_left = !window.show_left;
  if (item(bench, "Inspector", nullptr, window.show_right)) window.show_right = !window.show_right;
  if (item(bench, "Timings and log", nullptr, window.show_bottom)) window.show_bottom = !window.show_bottom;
  ImGui::Separator();
  if (item(bench, "Dark", nullptr, window.theme == ThemeName::dark)) window.theme = ThemeName::dark;
  if (item(bench, "Light", nullptr, window.theme == ThemeName::light)) window.theme = ThemeName::light;
  ImGui::Separator();
  if (item(bench, "Larger text", "Ctrl++")) window.zoom = std::min(window.zoom + 0.1F, 3.0F);
  if (item(bench, "Smaller text", "Ctrl+-")) window.zoom = std::max(window.zoom - 0.1F, 0.5F);
  ImGui::Separator();
  if (item(bench, "Full screen", "F11")) bench.requests.toggle_full_screen = true;
  if (item(bench, "Save a screenshot", "F12")) bench.requests.screenshot = true;
  ImGui::EndMenu();
}

void MenuBar::draw(Workbench& bench) {
  if (ImGui::BeginMainMenuBar()) {
    height_ = ImGui::GetWindowHeight();
    file_menu(bench);
    draw_edit_menu(bench);
    view_menu(bench);
    const bool help = ImGui::BeginMenu("Help");
    bench.ui_map.mark_item("menu:Help");
    if (help) {
      if (item(bench, "Keys and mouse", "F1")) bench.window.keys_page = true;
      ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
  }
}

}  // namespace inkbench
