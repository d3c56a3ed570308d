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

}  // namespace

void overlay_choice(WindowLayout& layout, UiMap& ui_map) {
  constexpr std::array<std::pair<const char*, const char*>, 3> kChoices{
      {{"Plain", "Pictures as they are (L)."},
       {"Reference", "The reference lines over every picture, by class (L)."},
       {"Matches", "Drawn lines that match the reference, drawn ones that do not, and missed ones (L)."}}};
  for (size_t i = 0; i < kChoices.size(); ++i) {
    const auto overlay = static_cast<Overlay>(i);
    if (i > 0) ImGui::SameLine(0, 2);
    if (toggle_button(kChoices[i].first, layout.overlay == overlay, kChoices[i].second))
      layout.overlay = overlay;
    ui_map.mark_item("overlay:" + std::to_string(i));
  }
}

void next_overlay(WindowLayout& layout) {
  layout.overlay = static_cast<Overlay>((static_cast<int>(layout.overlay) + 1) % 3);
}

void draw_overlay_legend(Viewer& viewer, const WindowLayout& layout, ImVec2 foot, float width) {
  const Overlay overlay = layout.overlay;
  if (overlay == Overlay::none) return;
  std::vector<Swatch> swatches = overlay == Overlay::reference
                                     ? reference_swatches(viewer.pictures.reference().now())
                                     : match_swatches(viewer.judge.now());
  const float pad = scaled(8);
  float total = total_width(swatches);
  while (swatches.size() > 1 && total + 2 * pad > width) {
    swatches.pop_back();
    total = total_width(swatches);
  }
  float x = std::floor(foot.x + std::max((width - total) / 2, pad));
  const float y = std::floor(foot.y - ImGui::GetTextLineHeight() - scaled(4));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({x - pad, y - scaled(4)}, {x + total + pad, foot.y}, with_alpha(theme().bar, 0.85F),
                     scaled(3));
  for (const Swatch& swatch : swatches) {
    draw_swatch(list, swatch, {x, y});
    x += width_of(swatch);
  }
}

}  // namespace inkbench
