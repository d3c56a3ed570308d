#include "app/panels/frame/edit_menu.h"

#include <imgui.h>

#include "app/panels/frame/file_dialogs.h"
#include "app/panels/widgets/clipboard.h"
#include "app/panels/widgets/widgets.h"

namespace inkbench {
namespace {

constexpr size_t kLongestStep = 40;

bool item(Workbench& bench, const std::string& label, const char* keys = nullptr, bool can = true,
          const char* mark = nullptr) {
  const bool chosen = ImGui::MenuItem(label.c_str(), keys, false, can);
  bench.ui_map.mark_item("menu:" + (mark != nullptr ? std::string(mark) : label));
  return chosen;
}

std::string with_step(const char* verb, const std::string& step) {
  if (step.empty()) return verb;
  if (step.size() <= kLongestStep) return std::string(verb) + " " + step;
  size_t end = kLongestStep;
  while (end > 0 && (static_cast<unsigned char>(step[end]) & 0xc0) == 0x80) --end;  // not within a letter
  return std::string(verb) + " " + step.substr(0, end) + "…";
}

void recent_menu(Workbench& bench) {
  const std::vector<std::filesystem::path> recent = bench.keeping.recent();  // opening changes the list
  const bool open = ImGui::BeginMenu("Recent files", !recent.empty());
  bench.ui_map.mark_item("menu:Recent files");
  if (!open) return;
  for (size_t i = 0; i < recent.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (item(bench, recent[i].filename().string())) bench.open(recent[i].string());
    help_for_item(recent[i].string());
    ImGui::PopID();
  }
  ImGui::EndMenu();
}

}  // namespace

void draw_file_items(Workbench& bench) {
  if (item(bench, "Open...", "Ctrl+O")) bench.wanted_dialog = FileDialog::open;
  recent_menu(bench);
  ImGui::Separator();
  if (item(bench, "Save settings", "Ctrl+S")) save_settings(bench);
  if (item(bench, "Save settings as...", "Ctrl+Shift+S")) bench.wanted_dialog = FileDialog::save_settings;
  if (item(bench, "Save a picture...", "Ctrl+E")) bench.wanted_dialog = FileDialog::save_image;
  ImGui::Separator();
}

void draw_edit_menu(Workbench& bench) {
  const bool open = ImGui::BeginMenu("Edit");
  bench.ui_map.mark_item("menu:Edit");
  if (!open) return;
  const History& history = bench.history();
  if (item(bench, with_step("Undo", history.undo_name()), "Ctrl+Z", history.can_undo(), "Undo")) bench.undo();
  if (item(bench, with_step("Redo", history.redo_name()), "Ctrl+Shift+Z", history.can_redo(), "Redo"))
    bench.redo();
  ImGui::Separator();
  if (item(bench, "Copy as a command", "Ctrl+Shift+C")) copy_render_command(bench);
  if (item(bench, "Copy settings")) copy_settings(bench);
  if (item(bench, "Paste settings or a path", "Ctrl+V")) paste(bench);
  ImGui::Separator();
  if (item(bench, "Reset all to the scene")) bench.replace(bench.baseline(), "reset all");
  ImGui::EndMenu();
}

}  // namespace inkbench
