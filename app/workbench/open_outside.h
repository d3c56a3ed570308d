// SPDX-License-Identifier: MIT
// A file or folder in the program that the desktop has for it.
#pragma once

#include <filesystem>

namespace inkbench {

/// Errors (work): there is no `xdg-open` to ask.
void open_outside(const std::filesystem::path& path);

}  // namespace inkbench
