// SPDX-License-Identifier: MIT
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

ImU32 term_colour(size_t term) {
  return term % 2 == 0 ? theme().accent : theme().accent_soft;
}

/// The term of which the most of its limit is there.
size_t largest_term(const Explanation& why) {
  const auto less = [](const ExplainedTerm& a, const ExplainedTerm& b) {
    return (a.used ? a.value / a.limit : 0.0) < (b.used ? b.value / b.limit : 0.0);
  };
  return static_cast<size_t>(std::max_element(why.terms.begin(), why.terms.end(), less) - why.terms.begin());
}

/// All terms one after the other, or the largest, and where the limit is.
void draw_sum(const Explanation& why) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = scaled(14);
  const float top = low.y + scaled(4);
  double largest = why.by_largest ? 2 * why.limit : 0;
  for (const ExplainedTerm& term : why.terms) largest += why.by_largest ? 0 : term.limit;
  const auto x_of = [&](double sum) {
    return low.x + static_cast<float>(std::min(sum / largest, 1.0)) * width;
  };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({low.x, top}, {low.x + width, top + height}, theme().field, scaled(2));
  double sum = 0;
  if (why.by_largest)
    list.AddRectFilled({low.x, top}, {x_of(why.sum), top + height}, term_colour(largest_term(why)));
  for (size_t i = 0; i < why.terms.size() && !why.by_largest; ++i) {
    const float from = x_of(sum);
    sum += why.terms[i].value;
    list.AddRectFilled({from, top}, {x_of(sum), top + height}, term_colour(i));
  }
  const float line = std::round(std::clamp(x_of(why.limit), low.x + 1, low.x + width - 1));
  list.AddLine({line, top - scaled(3)}, {line, top + height + scaled(3)}, theme().text, scaled(2));
  ImGui::Dummy({width, height + scaled(8)});
  const std::string text = why.limit_name + " " + number_text(static_cast<float>(why.limit), false);
  const float text_width = ImGui::CalcTextSize(text.c_str()).x;
  const float place = std::clamp(line - text_width / 2, low.x, low.x + width - text_width);
  ImGui::SetCursorScreenPos({place, ImGui::GetCursorScreenPos().y - scaled(3)});
  faint_text(text);
}

const ExplainedInput* input_of(const ExplainedTerm& term, ExplainedInput::Role role) {
  const auto found = std::find_if(term.inputs.begin(), term.inputs.end(),
                                  [&](const ExplainedInput& input) { return input.role == role; });
  return found == term.inputs.end() ? nullptr : &*found;
}

/// 3 x 3 from the smallest value (black) to the largest (white), both of them framed.
void draw_miniature(const ExplainedTerm& term) {
  const float cell = scaled(19);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto corner = [&](int i) {
    return ImVec2{low.x + static_cast<float>(i % 3) * cell, low.y + static_cast<float>(i / 3) * cell};
  };
  const auto frame = [&](const ExplainedInput* input, ImU32 colour) {
    if (input == nullptr || !input->at) return;
    const ImVec2 from = corner((input->at->dy + 1) * 3 + input->at->dx + 1);
    list.AddRect({from.x + 1, from.y + 1}, {from.x + cell - 2, from.y + cell - 2}, colour, 0, 0, scaled(2));
  };
  const ExplainedInput* largest = input_of(term, ExplainedInput::Role::largest);
  const ExplainedInput* smallest = input_of(term, ExplainedInput::Role::smallest);
  const double least = smallest == nullptr ? 0.0 : smallest->value;
  const double span = largest == nullptr ? 1.0 : largest->value - least;
  for (int i = 0; i < 9; ++i) {
    const std::optional<float>& value = term.around[static_cast<size_t>(i)];
    const ImVec2 from = corner(i);
    const double share = value && span > 0 ? (*value - least) / span : 0.0;
    const auto grey = static_cast<int>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
    list.AddRectFilled(from, {from.x + cell - 1, from.y + cell - 1},
                       value ? IM_COL32(grey, grey, grey, 255) : theme().field);
  }
  list.AddRect({low.x - 1, low.y - 1}, {low.x + 3 * cell, low.y + 3 * cell}, theme().line);
  if (span > 0) {
    frame(smallest, theme().mark);
    frame(largest, theme().accent);
  }
  ImGui::Dummy({3 * cell, 3 * cell});
}

void draw_number(const std::string& name, double value, const std::string& unit, ImU32 colour) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  coloured_text(colour, name);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(
      (number_text(static_cast<float>(value), false) + (unit.empty() ? "" : " " + unit)).c_str());
}

ImU32 input_colour(ExplainedInput::Role role) {
  if (role == ExplainedInput::Role::largest) return theme().accent;
  return role == ExplainedInput::Role::smallest ? theme().mark : theme().faint;
}

void draw_numbers(const ExplainedTerm& term, bool by_largest) {
  if (!ImGui::BeginTable(term.name.c_str(), 2, ImGuiTableFlags_SizingFixedFit)) return;
  for (const ExplainedInput& input : term.inputs)
    draw_number(input.name, input.value, input.unit, input_colour(input.role));
  draw_number(by_largest ? "value" : "adds", term.value, term.unit, theme().text);
  if (by_largest) draw_number("limit", term.limit, term.unit, theme().text);
  ImGui::EndTable();
}

void draw_term(const ExplainedTerm& term, bool by_largest, ImU32 colour) {
  ImGui::Dummy({0, scaled(2)});
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const float size = scaled(9);
  const float top = place.y + (ImGui::GetTextLineHeight() - size) / 2 + 1;
  ImGui::GetWindowDrawList()->AddRectFilled({place.x, top}, {place.x + size, top + size}, colour);
  ImGui::SetCursorScreenPos({place.x + size + scaled(6), place.y});
  ImGui::TextUnformatted(term.title.c_str());
  if (!term.used) {
    ImGui::SameLine();
    faint_text("is switched off");
    return;
  }
  draw_miniature(term);
  ImGui::SameLine(0, scaled(10));
  draw_numbers(term, by_largest);
  if (term.cause.empty()) return;
  std::string cause = term.cause;
  cause[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(cause[0])));
  wrapped_text(cause + ".", theme().faint);
}

void draw_verdict(const Explanation& why) {
  wrapped_text(why.verdict, theme().text);
  draw_sum(why);
}

void draw_terms(const Explanation& why) {
  for (size_t i = 0; i < why.terms.size(); ++i) draw_term(why.terms[i], why.by_largest, term_colour(i));
}

/// A button for each value that would change the pixel, `change:KEY` of the map.
void draw_changes(const Explanation& why, Document& document, UiMap& ui_map) {
  ImGui::Dummy({0, scaled(2)});
  if (why.changes.empty()) {
    faint_text(why.is_line ? "No single limit removes it." : "No single limit draws it.");
    return;
  }
  faint_text(why.is_line ? "Remove it by" : "Draw it by");
  for (const ExplainedChange& change : why.changes) {
    const std::string label = change.parameter + " = " + to_text(change.value);
    if (ImGui::Button(label.c_str())) document.change(change.parameter, change.value);
    ui_map.mark_item("change:" + change.parameter);
    help_for_item("It is " + to_text(change.now) + " now. The nearest value that does it.");
  }
}

/// Of the marked pixel or of one within the judge's tolerance; nothing where none of them is wrong.
void draw_cause(const CauseDesk& causes, const MarkedPixel& pixel, UiMap& ui_map) {
  if (causes.now() == nullptr) return;
  const auto found = cause_near(*causes.now(), pixel.x, pixel.y, causes.tolerance_px());
  if (!found) return;
  const auto& [r, g, b] = info_of(found->cause).colour;
  ImGui::Dummy({0, scaled(2)});
  const ImVec2 place = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(
      place, {place.x + scaled(3), place.y + ImGui::GetTextLineHeight()}, IM_COL32(r, g, b, 255));
  ImGui::SetCursorScreenPos({place.x + scaled(8), place.y});
  wrapped_text(cause_text(*found), theme().text);
  ui_map.mark_item("why cause");
}

/// Of the state that was asked; nothing while its picture is not there yet.
const Explanation* explanation_of(Viewer& viewer, const MarkedPixel& pixel, bool pinned) {
  if (pinned) return &viewer.explain_pinned(pixel.x, pixel.y);
  const std::optional<Frame>& drawn = viewer.drawn();
  if (!viewer.can_draw() || !drawn) return nullptr;
  const ImageParams& image = drawn->settings().image;
  if (pixel.x >= image.width || pixel.y >= image.height)
    return nullptr;  // the next frame brings a larger one
  return &viewer.explain(pixel.x, pixel.y);
}

}  // namespace

void draw_why(Document& document, Viewer& viewer, ViewState& view, UiMap& ui_map) {
  if (!view.marked) {
    wrapped_text("Click a pixel to see why it is a line or not.", theme().faint);
    return;
  }
  move_mark(document, viewer.pictures, view, 0, 0);  // the image may be smaller now
  const bool pinned = asks_pinned(view) && viewer.pictures.pinned_maps();
  ImGui::PushFont(fonts().bold);
  ImGui::Text("Why pixel %d, %d%s?", view.marked->x, view.marked->y, pinned ? ", pinned" : "");
  ImGui::PopFont();
  ui_map.mark_item(pinned ? "why pinned" : "why");
  try {
    const Explanation* why = explanation_of(viewer, *view.marked, pinned);
    if (why == nullptr) return;
    draw_verdict(*why);
    if (!pinned) {  // its settings are others
      draw_cause(viewer.judge.causes, *view.marked, ui_map);
      draw_changes(*why, document, ui_map);
    }
    draw_terms(*why);
  } catch (const Error&) {
    faint_text("?");  // told by the banner
  }
}

}  // namespace inkbench
