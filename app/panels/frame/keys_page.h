// The page of keys and mouse: shown at the first start, and by F1.
#pragma once

#include "app/window/workbench.h"

namespace inkbench {

/// Over everything else while `bench.layout.show_welcome` says so.
void draw_keys_page(Workbench& bench);

}  // namespace inkbench
