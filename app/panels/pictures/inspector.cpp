#include "app/panels/pictures/inspector.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "app/panels/pictures/histogram_view.h"
#include "app/panels/pictures/why_view.h"
#include "app/panels/widgets/value_bar.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "pipeline/base/error.h"

namespace inkbench {
namespace {

std::string values_text(const Image& pixel) {
  if (pixel.channels == 1) return number_text(pixel.at(0, 0), false);
  return fmt::format("{:.3f} {:.3f} {:.3f}", pixel.at(0, 0, 0), pixel.at(0, 0, 1), pixel.at(0, 0, 2));
}

/// How the buffer is shown.
void draw_choice(Workbench& bench, BufferName buffer) {
  PictureChoice& choice = bench.pictures.choice(buffer);
  constexpr std::array kKinds{"With the display gains", "Fitted: smallest to largest", "Between two values"};
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##kind", kKinds[static_cast<size_t>(choice.kind)])) {
    for (size_t i = 0; i < kKinds.size(); ++i) {
      const auto kind = static_cast<PictureChoice::Kind>(i);
      if (!ImGui::Selectable(kKinds[i], choice.kind == kind)) continue;
      if (kind == PictureChoice::Kind::fixed) choice.fixed = shown_range(bench, buffer);
      choice.kind = kind;
    }
    ImGui::EndCombo();
  }
  bench.ui_map.mark_item("picture choice");
}

void draw_buffer(Workbench& bench, BufferName buffer) {
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(name_of(buffer).data());
  ImGui::PopFont();
  wrapped_text(std::string(buffer.info().help), theme().faint);
  const ShownPicture& shown = bench.pictures.shown(buffer, false);
  if (shown.texture != nullptr)
    faint_text(fmt::format("{} × {} px", shown.texture->width_px(), shown.texture->height_px()));
  ImGui::Dummy({0, scaled(2)});
  if (has_range(buffer)) draw_choice(bench, buffer);
}

void value_row(Workbench& bench, BufferName buffer, const HoveredPixel& pixel) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  coloured_text(buffer == pixel.picture.buffer ? theme().text : theme().faint, name_of(buffer));
  ImGui::TableNextColumn();
  // Those that are drawn, not those that this frame's mouse made: reading must not run a pass.
  const std::optional<Frame>& frame = bench.drawn();
  if (!frame || pixel.x >= frame->settings().image.width || pixel.y >= frame->settings().image.height) return;
  try {
    ImGui::TextUnformatted(values_text(frame->pixel(buffer, pixel.x, pixel.y)).c_str());
  } catch (const Error&) {
    faint_text("?");  // told by the banner
  }
}

void draw_values(Workbench& bench, const HoveredPixel& pixel) {
  if (!ImGui::BeginTable("values", 2)) return;
  ImGui::TableSetupColumn("buffer", ImGuiTableColumnFlags_WidthFixed,
                          ImGui::CalcTextSize("combined_edges").x);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  for (const BufferName buffer : all_buffers()) {
    const bool has_values = buffer.info().shown_as != ShownAs::drawing;
    if (has_values && bench.is_listed(buffer)) value_row(bench, buffer, pixel);
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

void InspectorPanel::draw_pixel(Workbench& bench) {
  if (bench.view.hovered && !bench.view.hovered->picture.pinned) pixel_ = bench.view.hovered;
  std::optional<HoveredPixel> pixel = pixel_;
  if (!bench.view.hovered && bench.view.marked)
    pixel = HoveredPixel{{bench.view.selected, false}, bench.view.marked->x, bench.view.marked->y};
  if (!pixel) {
    wrapped_text("Move the mouse over a picture to read the value of every buffer there.", theme().faint);
    return;
  }
  ImGui::PushFont(fonts().bold);
  ImGui::Text("Pixel %d, %d", pixel->x, pixel->y);
  ImGui::PopFont();
  draw_values(bench, *pixel);
}

void InspectorPanel::draw(Workbench& bench) {
  const bool can_draw = !bench.problems().contains(ProblemKind::drawing);
  const BufferName selected = bench.view.filled.value_or(bench.view.selected);
  if (bench.view.marked) {
    draw_why(bench);
    divide();
  }
  draw_buffer(bench, selected);
  if (can_draw && has_range(selected)) histogram_.draw(bench, selected);
  divide();
  if (can_draw) draw_pixel(bench);
  if (bench.view.marked) return;
  divide();
  draw_why(bench);
}

}  // namespace inkbench
