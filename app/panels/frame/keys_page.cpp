// SPDX-License-Identifier: MIT
#include "app/panels/frame/keys_page.h"

#include <imgui.h>

#include <array>

#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"

namespace inkbench {
namespace {

struct Entry {
  const char* keys;
  const char* meaning;
};

constexpr std::array kPictures{
    Entry{"Wheel", "zoom all pictures about the mouse"},
    Entry{"Drag", "move the pictures"},
    Entry{"Double click", "fill the window with one; again for all"},
    Entry{"1 to 9, 0", "fill the window with that buffer"},
    Entry{"Esc", "back to all"},
    Entry{"F, Z", "fit; one to one"},
    Entry{"C, Space", "compare two; flip between them"},
    Entry{"Click", "why a pixel is a line or not"},
    Entry{"Arrows, Esc", "move that pixel, with Shift by ten; forget it"},
    Entry{"L", "reference lines, right and wrong ones, none"},
    Entry{"J", "judge the lines; back to the inspector"},
    Entry{"P", "pin this state to compare with"},
    Entry{"W", "show the meshes' triangles"},
    Entry{"M", "paint what is wanted and what is not"},
    Entry{"Right click", "save it, fit its range, copy its command"},
};

constexpr std::array kParameters{
    Entry{"Drag", "set; with Shift finer; Esc gives it up"},
    Entry{"Ctrl+click", "type a number"},
    Entry{"Right click", "reset to the scene's value"},
    Entry{"R", "edit the ramps; Delete removes a stop"},
    Entry{"T", "stroke styles; draw the width by hand"},
    Entry{"Ctrl+F", "search parameters"},
    Entry{"S, Shift+S", "sweep the one under the mouse; as a grid"},
};

constexpr std::array kCamera{
    Entry{"Alt+drag", "turn about the target"},
    Entry{"Alt+Shift+drag", "move along the picture"},
    Entry{"Alt+wheel", "nearer, farther"},
    Entry{"X", "orthographic, or perspective again"},
    Entry{"O, V", "the mouse for the camera; for the view"},
    Entry{"Ctrl+1 to 9", "keep the camera"},
    Entry{"Shift+1 to 9", "back to a kept camera"},
    Entry{"Home", "fit the scene; with Shift the model"},
};

constexpr std::array kFiles{
    Entry{"Ctrl+Z, Ctrl+Y", "undo; redo (or Ctrl+Shift+Z)"},
    Entry{"Ctrl+O", "open a file; or drop it here"},
    Entry{"Ctrl+S", "save settings; with Shift elsewhere"},
    Entry{"Ctrl+E", "save a picture"},
    Entry{"Ctrl+Shift+C", "copy the command that draws this"},
    Entry{"Ctrl+V", "open a copied path; take settings"},
};

constexpr std::array kWindow{
    Entry{"Tab", "pictures alone; again for all panels"},
    Entry{"F3", "the studies, or the pictures"},
    Entry{"F11, F12", "full screen; save a screenshot"},
    Entry{"Ctrl+Q", "quit"},
    Entry{"F1", "this page"},
};

constexpr ImGuiWindowFlags kFlags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

template <size_t kCount>
void draw_list(const char* title, const std::array<Entry, kCount>& entries) {
  ImGui::PushFont(fonts().bold);
  coloured_text(theme().accent, title);
  ImGui::PopFont();
  if (!ImGui::BeginTable(title, 2)) return;
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, scaled(120));
  ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch);
  for (const Entry& entry : entries) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(entry.keys);
    ImGui::TableNextColumn();
    wrapped_text(entry.meaning, theme().faint);
  }
  ImGui::EndTable();
  ImGui::Dummy({0, scaled(6)});
}

void draw_columns(float height) {
  const float room = ImGui::GetContentRegionAvail().x;
  const bool two = room > scaled(600);
  ImGui::BeginChild("left", {two ? (room - scaled(24)) / 2 : room, height});
  draw_list("Pictures", kPictures);
  draw_list("Parameters", kParameters);
  if (two) {
    ImGui::EndChild();
    ImGui::SameLine(0, scaled(24));
    ImGui::BeginChild("right", {0, height});
  }
  draw_list("Undo and files", kFiles);
  draw_list("Camera", kCamera);
  draw_list("Window", kWindow);
  ImGui::EndChild();
}

}  // namespace

void draw_keys_page(WindowLayout& layout, UiMap& ui_map) {
  if (!layout.show_welcome) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(screen);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(0, 0, 0, 110));
  ImGui::Begin("behind the keys", nullptr, kFlags);
  if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) layout.show_welcome = false;
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSize({std::min(scaled(980), screen.x - scaled(20)), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(24), scaled(16)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, scaled(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, theme().bar);
  ImGui::Begin("keys and mouse", nullptr, kFlags);
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted("Keys and mouse");
  ImGui::PopFont();
  faint_text("Every number has a slider on the left; every picture follows at once.");
  ImGui::Dummy({0, scaled(8)});
  draw_columns(std::min(scaled(500), screen.y - scaled(160)));
  if (ImGui::Button("Start", {scaled(110), 0})) layout.show_welcome = false;
  ui_map.mark_item("start");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  faint_text("Esc closes this page, F1 shows it again.");
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

}  // namespace inkbench
