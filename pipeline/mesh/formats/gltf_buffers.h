// SPDX-License-Identifier: MIT
// The files that a glTF file keeps its numbers in. In: its text. Out: paths relative to it.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace inkbench {

/// The buffers that are files of their own, in their order; none where the text is no glTF.
std::vector<std::filesystem::path> gltf_buffers(std::string_view text);

}  // namespace inkbench
