// SPDX-License-Identifier: MIT
// Small text helpers: numbers that read back exactly, joined lists, the nearest name for a misspelt one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace inkbench {

/// The shortest decimal text that reads back as the same number ("0.003", "1e-06").
std::string shortest(float value);
std::string shortest(double value);

/// A count with thousands separated: 69666 -> "69,666".
std::string with_commas(long long count);

/// A count for a message: "1 face", "2,000 faces".
std::string counted(uint64_t count, std::string_view one, std::string_view many);

/// So many lower-case hexadecimal digits and nothing else.
bool is_hex(std::string_view text, size_t digits);

/// What stands before `ending`; nothing where the text does not end so.
std::optional<std::string_view> without_ending(std::string_view text, std::string_view ending);

/// Bytes for people: "12 bytes", "3.1 MB", "812 kB".
std::string readable_bytes(double bytes);

std::string join(std::span<const std::string> parts, std::string_view separator);
std::vector<std::string> split(std::string_view text, char separator);
std::string_view trim(std::string_view text);

/// Capital letters of ASCII made small; the others stay as they are, whatever the locale.
std::string lower_case(std::string text);

/// Whether the bytes are UTF-8, which is all that TOML and image metadata can hold.
bool is_utf8(std::string_view text);

/// As it can be shown on a terminal without moving its cursor or changing its state: control characters and
/// marks that turn the direction of writing become "\u001b", bytes that are no UTF-8 "\xff". Line breaks and
/// tabs stay where `keep_lines`.
std::string printable(std::string_view text, bool keep_lines = false);

/// As one word of a POSIX shell's command line: as it is where it is plain, else in single quotes.
std::string shell_word(const std::string& text);

/// The candidate with the smallest edit distance to `name`, or "" where none is near enough to be meant.
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// "did you mean 'X'?" for the nearest candidate, else "one of: A, B, ..." when there are few, else "".
std::string suggest(std::string_view name, std::span<const std::string> candidates);

}  // namespace inkbench
