// SPDX-License-Identifier: MIT
// Numbers in text mesh files, each the double nearest to what stands there. In: tokens. Out: values; NaN,
// infinity and what is too large for a double are kept as not finite.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/mesh/formats/text_cursor.h"

namespace inkbench {

/// The token as a number, if it is one; "1.#IND" and the like, as Windows writes them, are NaN.
std::optional<double> parse_number(std::string_view token);

/// The token as a whole number, if it is one, brought to the limits of 64 bits.
std::optional<int64_t> parse_integer(std::string_view token);

/// The token as a count, if it is one.
std::optional<uint64_t> parse_count(std::string_view token);

/// Brought to the limits of 32 bits, which name no vertex either way.
int32_t to_index(int64_t value);

/// The next three tokens of the line as numbers. Errors (input): too few, or not numbers; `what` names them
/// ("a vertex").
glm::dvec3 read_three_numbers(TextCursor& cursor, const char* what);

/// The next three tokens, on later lines if need be. Errors (input): as above.
glm::dvec3 read_three_numbers_across_lines(TextCursor& cursor, const char* what);

/// "truncated: the header announces V vertices and F faces, but the file holds v and f".
Error truncation_error(const std::string& name, uint64_t announced_vertices, uint64_t announced_faces,
                       uint64_t found_vertices, uint64_t found_faces);

}  // namespace inkbench
