// SPDX-License-Identifier: MIT
#include "app/panels/pictures/overlay_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/panels/widgets/widgets.h"
#include "app/window/theme.h"
#include "pipeline/base/text.h"
#include "pipeline/lines/drawing.h"
#include "studies/measures/diff_picture.h"
#include "studies/measures/match_maps.h"

namespace inkbench {
namespace {

constexpr float kSwatch = 10, kBetween = 16;

struct Swatch {
  std::array<uint8_t, 3> colour;
  std::string text;
  const CauseInfo* cause = nullptr;  ///< Told on hover.
};

std::vector<Swatch> reference_swatches(const FoundLines* found) {
  std::vector<Swatch> swatches;
  for (const LineClass line_class : kLineClasses) {
    const auto has_class = [&](const Polyline& line) { return line.line_class == line_class; };
    const bool there = found == nullptr ||
                       std::any_of(found->lines->polylines.begin(), found->lines->polylines.end(), has_class);
    if (there) swatches.push_back({colour_of(line_class), std::string(name_of(line_class))});
  }
  return swatches;
}

std::vector<Swatch> match_swatches(const Judgement* now) {
  if (now == nullptr || !now->error.empty()) return {{kMissedColour, "measuring…"}};
  const MatchMaps& maps = now->maps;
  return {{kMatchedColour, "matched " + with_commas(maps.matched.count())},
          {kMissedColour, "missed " + with_commas(maps.missed.count())},
          {kFalseColour, "false " + with_commas(maps.wrong.count())},
          {kAllowedColour, "allowed " + with_commas(maps.allowed.count())}};
}

/// Those that there are, false ones first.
std::vector<Swatch> cause_swatches(const CauseDesk& desk) {
  constexpr std::array<uint8_t, 3> kGrey{150, 150, 150};
  if (!desk.error().empty()) return {{kGrey, desk.error()}};
  if (desk.now() == nullptr) return {{kGrey, "finding causes…"}};
  std::vector<Swatch> swatches;
  for (const CauseInfo& info : cause_table()) {
    const int64_t count = desk.counts().of(info.cause);
    const std::string kind = info.is_of_missed() ? "missed: " : "false: ";
    if (count > 0)
      swatches.push_back({info.colour, kind + std::string(info.name) + " " + with_commas(count), &info});
  }
  if (swatches.empty()) swatches.push_back({kGrey, "no line is false or missing"});
  return swatches;
}

std::vector<Swatch> swatches_of(Viewer& viewer, Overlay overlay) {
  if (overlay == Overlay::reference) return reference_swatches(viewer.pictures.reference().now());
  return overlay == Overlay::causes ? cause_swatches(viewer.judge.causes)
                                    : match_swatches(viewer.judge.now());
}

float width_of(const Swatch& swatch) {
  return scaled(kSwatch + 6 + kBetween) + ImGui::CalcTextSize(swatch.text.c_str()).x;
}

float total_width(const std::vector<Swatch>& swatches) {
  float total = -scaled(kBetween);
  for (const Swatch& swatch : swatches) total += width_of(swatch);
  return total;
}

void draw_swatch(ImDrawList& list, const Swatch& swatch, ImVec2 low) {
  const float size = scaled(kSwatch);
  const float top = low.y + (ImGui::GetTextLineHeight() - size) / 2 + 1;
  const auto& c = swatch.colour;
  list.AddRectFilled({low.x, top}, {low.x + size, top + size}, IM_COL32(c[0], c[1], c[2], 255));
  list.AddRect({low.x, top}, {low.x + size, top + size}, theme().faint);
  list.AddText({low.x + size + scaled(6), low.y}, theme().text, swatch.text.c_str());
}

/// As few rows as hold them; a row has at least one.
std::vector<std::vector<Swatch>> rows_of(const std::vector<Swatch>& swatches, float width) {
  std::vector<std::vector<Swatch>> rows(1);
  for (const Swatch& swatch : swatches) {
    std::vector<Swatch> longer = rows.back();
    longer.push_back(swatch);
    if (!rows.back().empty() && total_width(longer) > width) {
      rows.push_back({swatch});
    } else {
      rows.back() = std::move(longer);
    }
  }
  return rows;
}

/// What the cause under the mouse is and what would mend it.
void tell_of_cause(const Swatch& swatch, ImVec2 low, UiMap& ui_map) {
  if (swatch.cause == nullptr) return;
  const ImVec2 high{low.x + width_of(swatch) - scaled(kBetween), low.y + ImGui::GetTextLineHeight()};
  ui_map.mark("cause:" + std::string(swatch.cause->key), {low.x, low.y, high.x, high.y});
  if (!ImGui::IsWindowHovered() || !ImGui::IsMouseHoveringRect(low, high)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(scaled(320));
  ImGui::TextUnformatted(swatch.cause->help.data(), swatch.cause->help.data() + swatch.cause->help.size());
  coloured_text(theme().accent, "Would mend it: " + std::string(swatch.cause->remedy) + ".");
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace

void overlay_choice(WindowLayout& layout, UiMap& ui_map) {
  constexpr std::array<std::pair<const char*, const char*>, 4> kChoices{
      {{"Plain", "Pictures as they are (L)."},
       {"Reference", "The reference lines over every picture, by class (L)."},
       {"Matches", "Drawn lines that match the reference, drawn ones that do not, and missed ones (L)."},
       {"Causes", "Why lines are false or missing: one cause for each pixel (L)."}}};
  for (size_t i = 0; i < kChoices.size(); ++i) {
    const auto overlay = static_cast<Overlay>(i);
    if (i > 0) ImGui::SameLine(0, 2);
    if (i > 0 && ImGui::GetContentRegionAvail().x < button_width(kChoices[i].first)) ImGui::NewLine();
    if (toggle_button(kChoices[i].first, layout.overlay == overlay, kChoices[i].second))
      layout.overlay = overlay;
    ui_map.mark_item("overlay:" + std::to_string(i));
  }
}

void next_overlay(WindowLayout& layout) {
  layout.overlay = static_cast<Overlay>((static_cast<int>(layout.overlay) + 1) % 4);
}

void draw_overlay_legend(Viewer& viewer, const WindowLayout& layout, UiMap& ui_map, ImVec2 foot,
                         float width) {
  if (layout.overlay == Overlay::none) return;
  const float pad = scaled(8), line = ImGui::GetTextLineHeight() + scaled(4);
  const auto rows = rows_of(swatches_of(viewer, layout.overlay), width - 2 * pad);
  float widest = 0;
  for (const std::vector<Swatch>& row : rows) widest = std::max(widest, total_width(row));
  const float left = std::floor(foot.x + std::max((width - widest) / 2, pad));
  float y = std::floor(foot.y - line * static_cast<float>(rows.size()));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({left - pad, y - scaled(4)}, {left + widest + pad, foot.y},
                     with_alpha(theme().bar, 0.85F), scaled(3));
  for (const std::vector<Swatch>& row : rows) {
    float x = left;
    for (const Swatch& swatch : row) {
      draw_swatch(list, swatch, {x, y});
      tell_of_cause(swatch, {x, y}, ui_map);
      x += width_of(swatch);
    }
    y += line;
  }
}

}  // namespace inkbench
