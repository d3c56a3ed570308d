// What the clipboard carries to other programs and back: commands and settings as text.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// A line for a shell that draws the same; and all settings as a scene file's text.
void copy_render_command(Workbench& bench);
void copy_settings(Workbench& bench);

/// What was copied: settings as text, or a file's path, which is opened.
void paste(Workbench& bench);

}  // namespace inkbench
