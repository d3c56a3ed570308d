// SPDX-License-Identifier: MIT
// Files that a living process is told by: they have names that nobody can guess and are locked for as long as
// they are open, so that what a killed process left can be found, whatever its process id was.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "pipeline/base/descriptor.h"

namespace inkbench {

/// 16 hexadecimal digits that nobody can guess. Errors (work): the system has no random numbers.
std::string random_digits();

/// A new file, open for writing and locked; not open, and errno says why, where it cannot be made or the name
/// is taken, by whatever.
Descriptor make_locked_file(const std::filesystem::path& path, mode_t mode);

/// The file, open and locked, if it is a regular one of this user's that no living process holds; else not
/// open.
Descriptor take_abandoned(const std::filesystem::path& path);

}  // namespace inkbench
