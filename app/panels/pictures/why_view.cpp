#include "app/panels/pictures/why_view.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/panels/pictures/mark.h"
#include "app/panels/widgets/value_bar.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "pipeline/base/error.h"

namespace inkbench {
namespace {

constexpr float kLargestSum = 2;  // two terms of at most 1

std::vector<std::string> object_names(const Settings& settings) {
  std::vector<std::string> names;
  for (const ModelParams& model : settings.models) names.push_back(model.name);
  return names;
}

/// Both terms one after the other, and where the threshold is.
void draw_sum(const PixelWhy& why) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = scaled(14);
  const float top = low.y + scaled(4);
  const auto x_of = [&](float sum) { return low.x + std::min(sum / kLargestSum, 1.0F) * width; };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({low.x, top}, {low.x + width, top + height}, theme().field, scaled(2));
  const float split = x_of(why.depth.p);
  list.AddRectFilled({low.x, top}, {split, top + height}, theme().accent);
  list.AddRectFilled({split, top}, {x_of(why.sum), top + height}, theme().accent_soft);
  const float line = std::round(std::clamp(x_of(why.threshold), low.x + 1, low.x + width - 1));
  list.AddLine({line, top - scaled(3)}, {line, top + height + scaled(3)}, theme().text, scaled(2));
  ImGui::Dummy({width, height + scaled(8)});
  const std::string text = "threshold " + number_text(why.threshold, false);
  const float text_width = ImGui::CalcTextSize(text.c_str()).x;
  const float place = std::clamp(line - text_width / 2, low.x, low.x + width - text_width);
  ImGui::SetCursorScreenPos({place, ImGui::GetCursorScreenPos().y - scaled(3)});
  faint_text(text);
}

/// 3 x 3 from the smallest gradient (black) to the largest (white), both of them framed.
void draw_miniature(const Neighbourhood& values, const TermWhy& term) {
  const float cell = scaled(19);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto corner = [&](int i) {
    return ImVec2{low.x + static_cast<float>(i % 3) * cell, low.y + static_cast<float>(i / 3) * cell};
  };
  const auto frame = [&](const Offset& at, ImU32 colour) {
    const ImVec2 from = corner((at.dy + 1) * 3 + at.dx + 1);
    list.AddRect({from.x + 1, from.y + 1}, {from.x + cell - 2, from.y + cell - 2}, colour, 0, 0, scaled(2));
  };
  for (int i = 0; i < 9; ++i) {
    const std::optional<float>& value = values[static_cast<size_t>(i)];
    const ImVec2 from = corner(i);
    const float span = term.gmax - term.gmin;
    const float share = value && span > 0 ? (*value - term.gmin) / span : 0.0F;
    const auto grey = static_cast<int>(std::lround(255 * std::clamp(share, 0.0F, 1.0F)));
    list.AddRectFilled(from, {from.x + cell - 1, from.y + cell - 1},
                       value ? IM_COL32(grey, grey, grey, 255) : theme().field);
  }
  list.AddRect({low.x - 1, low.y - 1}, {low.x + 3 * cell, low.y + 3 * cell}, theme().line);
  if (term.gmax > term.gmin) {
    frame(term.min_at, theme().mark);
    frame(term.max_at, theme().accent);
  }
  ImGui::Dummy({3 * cell, 3 * cell});
}

void draw_number(const char* name, float value, ImU32 colour) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  coloured_text(colour, name);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(number_text(value, false).c_str());
}

void draw_numbers(const char* id, const TermWhy& term) {
  if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit)) return;
  draw_number("gmax", term.gmax, theme().accent);
  draw_number("gmin", term.gmin, theme().mark);
  draw_number("k", term.k, theme().faint);
  draw_number("p", term.p, theme().faint);
  ImGui::EndTable();
}

void draw_term(const char* name, const TermWhy& term, const Neighbourhood& values, bool is_depth,
               std::span<const std::string> names) {
  ImGui::Dummy({0, scaled(2)});
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const float size = scaled(9);
  const float top = place.y + (ImGui::GetTextLineHeight() - size) / 2 + 1;
  ImGui::GetWindowDrawList()->AddRectFilled({place.x, top}, {place.x + size, top + size},
                                            is_depth ? theme().accent : theme().accent_soft);
  ImGui::SetCursorScreenPos({place.x + size + scaled(6), place.y});
  ImGui::TextUnformatted(name);
  if (!term.used) {
    ImGui::SameLine();
    faint_text("is switched off");
    return;
  }
  draw_miniature(values, term);
  ImGui::SameLine(0, scaled(10));
  draw_numbers(name, term);
  if (term.step && term.gmax > term.gmin) {
    std::string cause = cause_text(*term.step, is_depth, names);
    cause[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(cause[0])));
    wrapped_text(cause + ".", theme().faint);
  }
}

void draw_probed(const Settings& drawn, const ProbedPixel& probed) {
  const std::vector<std::string> names = object_names(drawn);
  wrapped_text(verdict_text(probed.why), theme().text);
  draw_sum(probed.why);
  draw_term("Depth term", probed.why.depth, probed.depth_edges, true, names);
  draw_term("Normal term", probed.why.normal, probed.normal_edges, false, names);
}

}  // namespace

void draw_why(const Document& document, Viewer& viewer, ViewState& view, UiMap& ui_map) {
  if (!view.marked) {
    wrapped_text("Click a pixel to see why it is a line or not.", theme().faint);
    return;
  }
  move_mark(document, view, 0, 0);  // the image may be smaller now
  const auto& [x, y] = *view.marked;
  ImGui::PushFont(fonts().bold);
  ImGui::Text("Why pixel %d, %d?", x, y);
  ImGui::PopFont();
  ui_map.mark_item("why");
  const std::optional<Frame>& drawn = viewer.drawn();
  if (!viewer.can_draw() || !drawn) return;
  if (x >= drawn->settings().image.width || y >= drawn->settings().image.height)
    return;  // the larger image comes with the next frame
  try {
    draw_probed(drawn->settings(), viewer.probe.probe(*drawn, x, y));
  } catch (const Error&) {
    faint_text("?");  // told by the banner
  }
}

}  // namespace inkbench
