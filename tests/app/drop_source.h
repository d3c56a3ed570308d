// SPDX-License-Identifier: MIT
// Files dragged from a file manager and dropped on a window, by the XDND protocol (version 5).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace inkbench {

/// "file:///with%20blank.png", one a line.
std::string uri_list(const std::vector<std::filesystem::path>& files);

/// Drops on the middle of the display's first window that takes drops, and waits until it has taken them.
/// Throws std::runtime_error where there is no such window, it refuses, or it does not answer.
void drop(const std::string& display, const std::string& uri_list);

}  // namespace inkbench
