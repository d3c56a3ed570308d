// SPDX-License-Identifier: MIT
#include "app/panels/parameters/sweep_menu.h"

#include <imgui.h>

#include <vector>

#include "app/panels/widgets/attempt.h"
#include "app/panels/widgets/letter_key.h"

namespace inkbench {
namespace {

/// The parameter itself, or the components of a vector, with their names for the menu.
std::vector<std::string> sweepable(const Settings& settings, const std::string& key) {
  if (!has_param(settings, key)) return {};
  if (can_sweep(find_param(settings, key, key))) return {key};
  std::vector<std::string> keys;
  for (const std::string& other : sweepable_keys(settings)) {
    if (other.starts_with(key + ".")) keys.push_back(other);
  }
  return keys;
}

/// The form that another axis can be added to.
const StudyForm* open_form(const Studies& studies) {
  const StudyForm* form = studies.form();
  const bool takes_more =
      form != nullptr && !form->own_text && !form->request.axes.empty() && form->request.axes.size() < 3;
  return takes_more ? form : nullptr;
}

void items(const Document& document, Studies& studies, Problems& problems, UiMap& ui_map,
           const std::string& key, const std::string& sweep, const std::string& add) {
  if (ImGui::MenuItem(sweep.c_str(), "S"))
    attempt(problems, [&] { studies.sweep(document.settings(), key); });
  ui_map.mark_item("sweep:" + key);
  if (add.empty()) return;
  if (ImGui::MenuItem(add.c_str(), "Shift+S"))
    attempt(problems, [&] { studies.add_axis(document.settings(), key); });
  ui_map.mark_item("grid:" + key);
}

std::string add_label(const Studies& studies) {
  const StudyForm* form = open_form(studies);
  if (form == nullptr) return "";
  const std::string& first = form->request.axes.front().key;
  return "Grid of this and " + first.substr(first.find('.') + 1) + "...";
}

}  // namespace

void sweep_menu_items(const Document& document, Studies& studies, Problems& problems, UiMap& ui_map,
                      const std::string& key) {
  const std::vector<std::string> keys = sweepable(document.settings(), key);
  if (keys.empty()) return;
  ImGui::Separator();
  const std::string add = add_label(studies);
  for (const std::string& one : keys) {
    const std::string part = one == key ? "" : " " + one.substr(key.size() + 1);
    items(document, studies, problems, ui_map, one, "Sweep this" + part + "...",
          add.empty() ? "" : add + "##" + part);
  }
}

void sweep_key(const Document& document, Studies& studies, Problems& problems, const std::string& key) {
  if (!ImGui::IsItemHovered() || !letter_pressed('s')) return;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput || io.KeyCtrl || io.KeyAlt || popup_is_open()) return;
  const std::vector<std::string> keys = sweepable(document.settings(), key);
  if (keys.empty()) return;
  attempt(problems, [&] {
    if (io.KeyShift) {
      studies.add_axis(document.settings(), keys.front());
    } else {
      studies.sweep(document.settings(), keys.front());
    }
  });
}

}  // namespace inkbench
