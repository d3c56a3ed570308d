// SPDX-License-Identifier: MIT
// Mesh files that Debian packages bring, by package and name: real models that any Debian machine can get.
// In: "libcgal-demo/fandisk.off". Out: the file's path. What a package packs away is unpacked once into the
// cache.
#pragma once

#include <filesystem>
#include <string>

namespace inkbench {

/// "PACKAGE/FILE". Errors (input): a package that is not known, with those that are; one that is not
/// installed; a file that it does not bring; (work) its archive cannot be unpacked, for instance since
/// there is no cache folder.
std::filesystem::path find_package_mesh(const std::string& name);

}  // namespace inkbench
