// SPDX-License-Identifier: MIT
#include "app/panels/pictures/picture_menu.h"

#include <imgui.h>

#include "app/panels/widgets/clipboard.h"
#include "app/panels/widgets/widgets.h"

namespace inkbench {

void draw_picture_menu(const Document& document, Pictures& pictures, ViewState& view, Problems& problems,
                       WantedDialog& wanted_dialog, UiMap& ui_map, BufferName buffer) {
  const std::string id = "menu of " + std::string(name_of(buffer));
  const ImVec2 dragged = ImGui::GetMouseDragDelta(ImGuiMouseButton_Right, 0.0F);
  const bool clicked = ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Right) &&
                       dragged.x == 0.0F && dragged.y == 0.0F && !ImGui::GetIO().KeyAlt;
  if (clicked) ImGui::OpenPopup(id.c_str());
  if (!ImGui::BeginPopup(id.c_str())) return;
  view.selected = buffer;
  if (menu_item(ui_map, "Save this picture...", "Ctrl+E")) wanted_dialog = FileDialog::save_image;
  if (menu_item(ui_map, "Copy as a command", "Ctrl+Shift+C"))
    copy_render_command(document, pictures, view, problems);
  ImGui::Separator();
  if (menu_item(ui_map, "Fill the window", nullptr, view.filled == buffer))
    view.filled = view.filled ? std::nullopt : std::optional(buffer);
  PictureChoice& choice = pictures.choice(buffer);
  const bool fitted = choice.kind == PictureChoice::Kind::fitted;
  if (has_range(buffer) && menu_item(ui_map, "Fit the range", nullptr, fitted)) toggle_fit(choice);
  if (menu_item(ui_map, "Wireframe", "W", view.wireframe)) view.wireframe = !view.wireframe;
  ImGui::EndPopup();
}

}  // namespace inkbench
