// SPDX-License-Identifier: MIT
#include "app/panels/frame/file_menu.h"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "app/panels/frame/file_dialogs.h"
#include "app/panels/frame/shaders_menu.h"
#include "app/panels/widgets/widgets.h"
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

void FileMenu::draw_recent() {
  const std::vector<fs::path> recent = keeping_.recent();  // opening changes the list
  const bool open = ImGui::BeginMenu("Recent files", !recent.empty());
  ui_map_.mark_item("menu:Recent files");
  if (!open) return;
  for (size_t i = 0; i < recent.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (menu_item(ui_map_, recent[i].filename().c_str())) files_.open(recent[i].string());
    help_for_item(recent[i].string());
    ImGui::PopID();
  }
  ImGui::EndMenu();
}

void FileMenu::draw_scenes() {
  const bool open = ImGui::BeginMenu("Scenes");
  ui_map_.mark_item("menu:Scenes");
  if (!open) return;
  for (const fs::path& scene : bundled_scenes()) {
    if (menu_item(ui_map_, scene.stem().c_str())) files_.open(scene.string());
  }
  ImGui::EndMenu();
}

void FileMenu::draw() {
  const bool open = ImGui::BeginMenu("File");
  ui_map_.mark_item("menu:File");
  if (!open) return;
  if (menu_item(ui_map_, "Open...", "Ctrl+O")) wanted_dialog_ = FileDialog::open;
  draw_recent();
  ImGui::Separator();
  if (menu_item(ui_map_, "Save settings", "Ctrl+S")) save_settings(document_, problems_, wanted_dialog_);
  if (menu_item(ui_map_, "Save settings as...", "Ctrl+Shift+S")) wanted_dialog_ = FileDialog::save_settings;
  if (menu_item(ui_map_, "Save a picture...", "Ctrl+E")) wanted_dialog_ = FileDialog::save_image;
  ImGui::Separator();
  draw_scenes();
  ImGui::Separator();
  shaders_menu(problems_, ui_map_);
  ImGui::Separator();
  if (menu_item(ui_map_, "Quit", "Ctrl+Q")) requests_.close = true;
  ImGui::EndMenu();
}

}  // namespace inkbench
