// Rows of a CSV file (RFC 4180, with \n line ends).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace inkbench {

/// One line with its end; fields with commas, quotes or line breaks are quoted.
std::string csv_line(std::span<const std::string> fields);

/// The fields of every row that has its end; the rest of the text, a row that is still being written, is left
/// out. `used`: where that rest begins.
std::vector<std::vector<std::string>> csv_rows(std::string_view text, size_t& used);

}  // namespace inkbench
