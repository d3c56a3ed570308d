// Rows of a CSV file (RFC 4180, with \n line ends).
#pragma once

#include <span>
#include <string>

namespace inkbench {

/// One line with its end; fields with commas, quotes or line breaks are quoted.
std::string csv_line(std::span<const std::string> fields);

}  // namespace inkbench
