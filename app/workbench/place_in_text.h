// SPDX-License-Identifier: MIT
// The place in a file that a message names, so that an editor can be sent there.
#pragma once

#include <string>
#include <string_view>

namespace inkbench {

/// The first "file:line" of the text; "" where it names none.
std::string place_in_text(std::string_view text);

/// The same with a whole path, where the file lies in the project's folder or the working folder.
std::string whole_place(const std::string& place);

}  // namespace inkbench
