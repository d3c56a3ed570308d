// SPDX-License-Identifier: MIT
// The table of buffers: every one that a pass of the list gives.
#pragma once

#include <string>
#include <vector>

#include "pipeline/flow/buffer_name.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// Those with a number key by their keys (1 to 9, then 0), then the others in the order of the passes.
std::vector<BufferName> all_buffers();

/// "a,b" or "all" as buffers, each once, in the order given. Errors (input): an unknown name, with the
/// nearest one.
std::vector<BufferName> parse_buffers(const std::vector<std::string>& names, const std::string& where);

/// What a frame of these settings, without one before it, lacks for the buffer to hold anything: "a frame
/// before"; "" as a rule.
std::string lacking_for(BufferName buffer, const Settings& settings);

/// "normal, depth, ...": for help and errors.
std::string buffer_list();

}  // namespace inkbench
