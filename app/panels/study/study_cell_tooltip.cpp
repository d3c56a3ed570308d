// SPDX-License-Identifier: MIT
#include "app/panels/study/study_cell_tooltip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/panels/pictures/fitted_picture.h"
#include "app/panels/widgets/widgets.h"
#include "app/window/gui.h"
#include "app/window/theme.h"
#include "pipeline/base/text.h"
#include "studies/sweep/labels.h"

namespace inkbench {
namespace {

void tooltip_line(const std::string& name, const std::string& value, float column) {
  faint_text(name);
  ImGui::SameLine(column);
  ImGui::TextUnformatted(value.c_str());
}

void draw_numbers(const StudyResults& results, size_t cell, float column) {
  constexpr size_t kMost = 14;
  size_t shown = 0;
  for (size_t i = 0; i < results.numbers().size() && shown < kMost; ++i) {
    const std::string& text = results.number(cell, i);
    if (text.empty()) continue;
    tooltip_line(results.numbers()[i], short_number(text), column);
    ++shown;
  }
}

/// Larger than in the grid, where its cells are small.
void draw_preview(const StudyResults& results, size_t cell, size_t picture, Thumbnails& thumbnails,
                  ImVec2 cell_size) {
  const float width = scaled(240);
  const std::filesystem::path file = results.picture(cell, picture);
  if (file.empty() || cell_size.x > width * 0.75F) return;
  const ImVec2 room{std::floor(width), std::floor(width * cell_size.y / cell_size.x)};
  const Texture* texture = thumbnails.get(file, static_cast<int>(room.x), static_cast<int>(room.y), 1);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::Dummy(room);
  if (texture != nullptr) draw_fitted_picture(*ImGui::GetWindowDrawList(), *texture, low, room);
}

/// Nothing where the sizes are the same.
std::string size_note(const ImageParams& now, const ImageParams& taken) {
  const bool same = now.width == taken.width && now.height == taken.height;
  return same ? "" : fmt::format(" and {} × {} px", taken.width, taken.height);
}

}  // namespace

void draw_cell_tooltip(const StudyResults& results, size_t cell, size_t picture, Thumbnails& thumbnails,
                       ImVec2 cell_size, const ImageParams& now) {
  const StudySpec& spec = results.spec();
  const Cell made = make_cell(spec, cell);
  float column = 0;
  for (const Assignment& one : made.set) column = std::max(column, text_width(one.key));
  for (const std::string& name : results.numbers()) column = std::max(column, text_width(name));
  column = std::min(column, scaled(220)) + scaled(18);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(scaled(460));
  ImGui::PushFont(fonts().bold);
  ImGui::TextUnformatted(
      fmt::format("Cell {}{}{}", cell + 1, made.variant.empty() ? "" : "  ", made.variant).c_str());
  ImGui::PopFont();
  for (const Assignment& one : made.set) tooltip_line(one.key, label_text(one.value), column);
  if (results.has(cell) && results.error(cell).empty()) {
    ImGui::Dummy({0, scaled(2)});
    draw_numbers(results, cell, column);
    draw_preview(results, cell, picture, thumbnails, cell_size);
    faint_text("Click takes over these parameters" + size_note(now, results.image(cell, picture)) + ".");
  } else if (results.has(cell)) {
    coloured_text(theme().error, results.error(cell));
  } else {
    faint_text("Not drawn yet.");
  }
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace inkbench
