// SPDX-License-Identifier: MIT
// What of a C++ source decides what it computes. In: its text. Out: the code alone: no comments, no help
// texts, no layout.
#pragma once

#include <string>
#include <string_view>

namespace inkbench {

/// Two sources that differ in comments, blank lines, spaces or the strings after `.help =` give the same
/// text.
std::string code_text(std::string_view source);

}  // namespace inkbench
