// SPDX-License-Identifier: MIT
// The files that an image is made from, by what they held: meshes and ramps. In: settings. Out: a hash of
// each file, to be kept in an exported image's metadata, and which of those kept are others now.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/key.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

class MeshStore;

struct UsedFile {
  std::string key;   ///< The parameter that names it: "model.rabbit.mesh", "ramp.diffuse".
  std::string path;  ///< Empty where only the key was kept.
  std::string hash;  ///< Of the file's content, 32 hexadecimal digits.
};

/// Of visible models' mesh files and of ramps that are images and switched on. Of a mesh it is the content
/// that the store drew. Errors (input): a file cannot be read.
std::vector<UsedFile> used_files(const Settings& settings, MeshStore& meshes);

/// A line "KEY HASH" for each, and back; lines of any other form are left out.
std::string used_files_text(const std::vector<UsedFile>& files);
std::vector<UsedFile> used_files_from(std::string_view text);

/// The files among `before`, which went into an image made from `made_from`, that `now` still names in the
/// same way and that hold something else. Files that cannot be read are left to those who draw them. Errors
/// (input): the rabbit is not installed.
std::vector<UsedFile> changed_files(const std::vector<UsedFile>& before, const Settings& made_from,
                                    const Settings& now);

}  // namespace inkbench
