// SPDX-License-Identifier: MIT
// Where the workbench keeps what is a person's own: presets and the last session.
#pragma once

#include <filesystem>

namespace inkbench {

/// $XDG_CONFIG_HOME/inkbench where that variable is an absolute path, else ~/.config/inkbench. It need not be
/// there yet. Errors (work): neither XDG_CONFIG_HOME nor HOME says where.
std::filesystem::path user_folder();

/// The variable's value; empty where it is no absolute path, which the XDG specification says to ignore.
std::filesystem::path absolute_variable(const char* name);

}  // namespace inkbench
