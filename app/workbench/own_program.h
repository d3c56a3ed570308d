// SPDX-License-Identifier: MIT
// Where this very program lies: what runs studies, and what a copied command calls.
#pragma once

#include <filesystem>

namespace inkbench {

/// The whole path; a link that leads to it where the system does not say.
std::filesystem::path own_program();

}  // namespace inkbench
