// SPDX-License-Identifier: MIT
#include "app/panels/pictures/inspector.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "app/panels/pictures/histogram_view.h"
#include "app/panels/pictures/why_view.h"
#include "app/panels/widgets/value_bar.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/listed_buffers.h"
#include "app/window/pictures.h"
#include "app/window/theme.h"
#include "pipeline/base/error.h"

namespace inkbench {
namespace {

std::string values_text(const Image& pixel) {
  if (pixel.channels == 1) return number_text(pixel.at(0, 0), false);
  std::string text;
  for (int c = 0; c < pixel.channels; ++c)
    text += fmt::format("{}{:.3f}", c == 0 ? "" : " ", pixel.at(0, 0, c));
  return text;
}

/// How the buffer is shown.
void draw_choice(const Document& document, Pictures& pictures, UiMap& ui_map, BufferName buffer) {
  PictureChoice& choice = pictures.choice(buffer);
  constexpr std::array kKinds{"With the display gains", "Fitted: smallest to largest", "Between two values"};
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##kind", kKinds[static_cast<size_t>(choice.kind)])) {
    for (size_t i = 0; i < kKinds.size(); ++i) {
      const auto kind = static_cast<PictureChoice::Kind>(i);
      if (!ImGui::Selectable(kKinds[i], choice.kind == kind)) continue;
      if (kind == PictureChoice::Kind::fixed) choice.fixed = shown_range(document, pictures, buffer);
      choice.kind = kind;
    }
    ImGui::EndCombo();
  }
  ui_map.mark_item("picture choice");
}

void draw_buffer(const Document& document, Pictures& pictures, UiMap& ui_map, BufferName buffer) {
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(name_of(buffer).data());
  ImGui::PopFont();
  wrapped_text(std::string(buffer.info().help), theme().faint);
  const ShownPicture& shown = pictures.shown(buffer, false);
  if (shown.texture != nullptr)
    faint_text(fmt::format("{} × {} px", shown.texture->width_px(), shown.texture->height_px()));
  ImGui::Dummy({0, scaled(2)});
  if (has_range(buffer)) draw_choice(document, pictures, ui_map, buffer);
}

void pinned_value(const Pictures& pictures, BufferName buffer, const HoveredPixel& pixel) {
  const std::optional<KeptMaps>& maps = pictures.pinned_maps();
  if (!maps) return;
  const Image& image = maps->raw[buffer];
  if (pixel.x >= image.width_px || pixel.y >= image.height_px) return;
  Image one(1, 1, image.channels);
  for (int c = 0; c < image.channels; ++c) one.at(0, 0, c) = image.at(pixel.x, pixel.y, c);
  ImGui::TextUnformatted(values_text(one).c_str());
}

void value_row(Viewer& viewer, BufferName buffer, const HoveredPixel& pixel) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  coloured_text(buffer == pixel.picture.buffer ? theme().text : theme().faint, name_of(buffer));
  ImGui::TableNextColumn();
  if (pixel.picture.pinned) return pinned_value(viewer.pictures, buffer, pixel);
  // Those that are drawn, not those that this frame's mouse made: reading must not run a pass.
  const std::optional<Frame>& frame = viewer.drawn();
  if (!frame || pixel.x >= frame->settings().image.width || pixel.y >= frame->settings().image.height) return;
  try {
    ImGui::TextUnformatted(values_text(frame->pixel(buffer, pixel.x, pixel.y)).c_str());
  } catch (const Error&) {
    faint_text("?");  // told by the banner
  }
}

void draw_values(Viewer& viewer, const WindowLayout& layout, const HoveredPixel& pixel) {
  if (!ImGui::BeginTable("values", 2)) return;
  ImGui::TableSetupColumn("buffer", ImGuiTableColumnFlags_WidthFixed,
                          ImGui::CalcTextSize("combined_edges").x);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  for (const BufferName buffer : all_buffers()) {
    const bool has_values = buffer.info().shown_as != ShownAs::drawing;
    if (has_values && is_listed(layout, buffer)) value_row(viewer, buffer, pixel);
  }
  ImGui::EndTable();
}

}  // namespace

namespace {

void divide() {
  ImGui::Dummy({0, scaled(4)});
  ImGui::Separator();
  ImGui::Dummy({0, scaled(2)});
}

}  // namespace

void InspectorPanel::draw_pixel() {
  if (view_.hovered) pixel_ = view_.hovered;
  if (pixel_ && !viewer_.pictures.pinned_maps()) pixel_->picture.pinned = false;
  std::optional<HoveredPixel> pixel = pixel_;
  if (!view_.hovered && view_.marked)
    pixel = HoveredPixel{{view_.selected, asks_pinned(view_)}, view_.marked->x, view_.marked->y};
  if (!pixel) {
    wrapped_text("Move the mouse over a picture to read the value of every buffer there.", theme().faint);
    return;
  }
  ImGui::PushFont(fonts().bold);
  ImGui::Text("Pixel %d, %d%s", pixel->x, pixel->y, pixel->picture.pinned ? ", pinned" : "");
  ImGui::PopFont();
  draw_values(viewer_, layout_, *pixel);
}

void InspectorPanel::draw() {
  const bool can_draw = viewer_.can_draw();
  const BufferName selected = looked_at(view_);
  if (view_.marked) {
    draw_why(document_, viewer_, view_, ui_map_);
    divide();
  }
  draw_buffer(document_, viewer_.pictures, ui_map_, selected);
  if (can_draw && has_range(selected)) histogram_.draw(selected);
  divide();
  if (can_draw) draw_pixel();
  if (view_.marked) return;
  divide();
  draw_why(document_, viewer_, view_, ui_map_);
}

}  // namespace inkbench
