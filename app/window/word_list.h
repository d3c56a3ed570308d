// SPDX-License-Identifier: MIT
// A list of words in one text, as "a b c": how the layout remembers sets of names.
#pragma once

#include <string>
#include <string_view>

namespace inkbench {

bool has_word(const std::string& words, std::string_view word);

/// The list with the word or without it.
std::string with_word(const std::string& words, std::string_view word, bool present);

}  // namespace inkbench
