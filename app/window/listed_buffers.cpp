// SPDX-License-Identifier: MIT
#include "app/window/listed_buffers.h"

#include "app/window/word_list.h"

namespace inkbench {

bool is_listed(const WindowLayout& layout, BufferName buffer) {
  return !has_word(layout.hidden_buffers, name_of(buffer));
}

void set_listed(WindowLayout& layout, BufferName buffer, bool listed) {
  layout.hidden_buffers = with_word(layout.hidden_buffers, name_of(buffer), !listed);
}

std::vector<BufferName> wanted_buffers(const WindowLayout& layout, const ViewState& view) {
  std::vector<BufferName> wanted;
  if (view.comparison.active) {
    for (const ComparedPicture& side : {view.comparison.a, view.comparison.b}) {
      if (!side.pinned) wanted.push_back(side.buffer);
    }
    return wanted;
  }
  if (view.filled) return {*view.filled};
  for (const BufferName buffer : all_buffers()) {
    if (is_listed(layout, buffer)) wanted.push_back(buffer);
  }
  return wanted;
}

ComparedPicture meant_picture(const ViewState& view) {
  const Comparison& comparison = view.comparison;
  if (!comparison.active || !comparison.flips) return {looked_at(view), false};
  return comparison.shows_b ? comparison.b : comparison.a;
}

const Settings& settings_of(const ComparedPicture& picture, const Document& document,
                            const Pictures& pictures) {
  const std::optional<Settings>& pinned = pictures.pinned_settings();
  return picture.pinned && pinned ? *pinned : document.settings();
}

}  // namespace inkbench
