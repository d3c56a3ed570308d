// SPDX-License-Identifier: MIT
// What the clipboard carries to other programs and back: commands and settings as text.
#pragma once

#include "app/window/pictures.h"
#include "app/window/view_state.h"
#include "app/workbench/document.h"
#include "app/workbench/file_opener.h"
#include "app/workbench/problems.h"

namespace inkbench {

/// A line for a shell that draws the same; and all settings as a scene file's text.
void copy_render_command(const Document& document, const Pictures& pictures, const ViewState& view,
                         Problems& problems);
void copy_settings(const Document& document, Problems& problems);

/// What was copied: settings as text, or a file's path, which is opened.
void paste(Document& document, FileOpener& files, Problems& problems);

}  // namespace inkbench
