// SPDX-License-Identifier: MIT
#include "app/panels/frame/status_bar.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/panels/widgets/widgets.h"
#include "pipeline/gl/context.h"

namespace inkbench {

void draw_status_bar(const Document& document, const Viewer& viewer, const ViewState& view,
                     const Studies& studies) {
  const ImageParams& image = document.settings().image;
  std::string left = fmt::format("{}    {} × {} px    {:.0f} %", document.scene_name(), image.width,
                                 image.height, view.magnification * 100.0);
  if (const StudyJob* study = studies.running())
    left += fmt::format("    {}: {} of {}", study->title, study->done, study->total);
  if (viewer.ladders.is_busy()) left += "    preparing the triangle counts: the full mesh is shown";
  static const std::string renderer = renderer_info().renderer;
  const std::string right = fmt::format("{}    {:.1f} ms a frame", renderer, viewer.frame_times.mean_ms);
  faint_text(left);
  const float width = ImGui::CalcTextSize(right.c_str()).x;
  const float place = ImGui::GetWindowContentRegionMax().x - width;
  ImGui::SameLine();
  if (place > ImGui::GetCursorPosX()) {
    ImGui::SameLine(place);
    faint_text(right);
  }
}

}  // namespace inkbench
