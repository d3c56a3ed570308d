// SPDX-License-Identifier: MIT
// Where what took long to make is kept for the next time.
#pragma once

#include <filesystem>

namespace inkbench {

/// $INKBENCH_CACHE, else $XDG_CACHE_HOME/inkbench, else ~/.cache/inkbench. Empty, which keeps nothing, where
/// INKBENCH_CACHE is set to nothing or there is no home.
std::filesystem::path cache_folder();

}  // namespace inkbench
