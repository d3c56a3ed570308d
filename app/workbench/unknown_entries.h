// SPDX-License-Identifier: MIT
// What a newer version wrote into a file of settings and this one does not know. In: the document. Out: the
// document without it, and its names.
#pragma once

#include <string>
#include <vector>

#include "pipeline/params/toml_document.h"

namespace inkbench {

/// How an entry that was left out is named: "combine.glow (line 12)".
std::string left_out_name(const std::string& key, const TomlNode& node);

/// Takes every entry out that names no parameter and no group; those of a group go one by one. Entries that
/// are broken in another way stay.
std::vector<std::string> take_unknown_entries(TomlNode& document);

}  // namespace inkbench
