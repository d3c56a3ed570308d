#include "app/panels/overlay_legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/panels/widgets.h"
#include "app/window/theme.h"
#include "pipeline/base/text.h"
#include "studies/measures/diff_picture.h"
#include "studies/measures/match_maps.h"
#include "studies/reference/drawing.h"

namespace inkbench {
namespace {

struct Swatch {
  std::array<uint8_t, 3> colour;
  std::string text;
};

std::vector<Swatch> reference_swatches(const ReferenceLines* lines) {
  std::vector<Swatch> swatches;
  for (const LineClass line_class : kLineClasses) {
    const auto has_class = [&](const Polyline& line) { return line.line_class == line_class; };
    const bool there =
        lines == nullptr || std::any_of(lines->polylines.begin(), lines->polylines.end(), has_class);
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
  return scaled(10 + 6 + 16) + ImGui::CalcTextSize(swatch.text.c_str()).x;
}

}  // namespace

void overlay_choice(Workbench& bench) {
  constexpr std::array<std::pair<const char*, const char*>, 3> kChoices{
      {{"Plain", "Pictures as they are (L)."},
       {"Reference", "The reference lines over every picture, by class (L)."},
       {"Matches", "Drawn lines that match the reference, drawn ones that do not, and missed ones (L)."}}};
  for (size_t i = 0; i < kChoices.size(); ++i) {
    const auto overlay = static_cast<Overlay>(i);
    if (i > 0) ImGui::SameLine(0, 2);
    if (toggle_button(kChoices[i].first, bench.layout.overlay == overlay, kChoices[i].second))
      bench.layout.overlay = overlay;
    bench.ui_map.mark_item("overlay:" + std::to_string(i));
  }
}

void next_overlay(Workbench& bench) {
  bench.layout.overlay = static_cast<Overlay>((static_cast<int>(bench.layout.overlay) + 1) % 3);
}

float draw_overlay_legend(Workbench& bench, ImVec2 foot, float width) {
  const Overlay overlay = bench.layout.overlay;
  if (overlay == Overlay::none) return 0;
  const std::vector<Swatch> swatches = overlay == Overlay::reference ? reference_swatches(bench.judge.lines())
                                                                     : match_swatches(bench.judge.now());
  const float height = ImGui::GetTextLineHeight() + scaled(8);
  float total = -scaled(16);
  for (const Swatch& swatch : swatches) total += width_of(swatch);
  float x = foot.x + std::max((width - total) / 2, 0.0F);
  const float y = foot.y - ImGui::GetTextLineHeight();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float size = scaled(10);
  for (const Swatch& swatch : swatches) {
    if (x + width_of(swatch) - scaled(16) > foot.x + width + 1) break;
    const float top = y + (ImGui::GetTextLineHeight() - size) / 2 + 1;
    const auto& c = swatch.colour;
    list.AddRectFilled({x, top}, {x + size, top + size}, IM_COL32(c[0], c[1], c[2], 255));
    list.AddRect({x, top}, {x + size, top + size}, theme().faint);
    list.AddText({x + size + scaled(6), y}, theme().text, swatch.text.c_str());
    x += width_of(swatch);
  }
  return height;
}

}  // namespace inkbench
