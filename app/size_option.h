// SPDX-License-Identifier: MIT
// "1024x768" on a command line.
#pragma once

#include <string>

#include "pipeline/settings/settings.h"

namespace inkbench {

/// Sets the image's size from "WIDTHxHEIGHT". Errors (input): another form, or a side out of range.
void apply_size(Settings& settings, const std::string& text);

}  // namespace inkbench
