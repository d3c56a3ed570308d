// SPDX-License-Identifier: MIT
// Which buffers are looked at: those that the sheet lists, or those that fill the window. In: layout and
// view.
#pragma once

#include <vector>

#include "app/window/pictures.h"
#include "app/window/view_state.h"
#include "app/workbench/document.h"
#include "app/workbench/window_layout.h"

namespace inkbench {

/// Whether the sheet shows the buffer.
bool is_listed(const WindowLayout& layout, BufferName buffer);
void set_listed(WindowLayout& layout, BufferName buffer, bool listed);

/// The buffers whose pictures of now are seen.
std::vector<BufferName> wanted_buffers(const WindowLayout& layout, const ViewState& view);

/// The one that a person means: what fills the window, else the selected one.
inline BufferName looked_at(const ViewState& view) {
  return view.filled.value_or(view.selected);
}

/// The picture that saving and copying mean: of two that are flipped the one that is seen, which may be
/// pinned; else the one that is looked at, as it is now.
ComparedPicture meant_picture(const ViewState& view);

/// What it is drawn with.
const Settings& settings_of(const ComparedPicture& picture, const Document& document,
                            const Pictures& pictures);

}  // namespace inkbench
