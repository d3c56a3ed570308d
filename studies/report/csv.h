// SPDX-License-Identifier: MIT
// Rows of a CSV file (RFC 4180, with \n line ends), written and read back.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace inkbench {

/// One line with its end; fields with commas, quotes or line breaks are quoted. A field that a spreadsheet
/// would take for a formula, since it begins with =, +, -, @ or a tab and is not made of numbers, gets an
/// apostrophe in front, which reading takes away.
std::string csv_line(std::span<const std::string> fields);

/// Whether writing puts an apostrophe in front of the field.
bool gets_apostrophe(std::string_view field);

/// A whole file, its head apart. Every row has as many fields as there are columns.
struct CsvTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  /// The place of the column of that name. Errors (work): there is none.
  size_t column(std::string_view name) const;
};

/// Fields that a row lacks are empty, those beyond the head's are dropped; a text without a head is an empty
/// table.
CsvTable parse_csv(std::string_view text);

/// The fields of every row that has its end; the rest of the text, a row that is still being written, is left
/// out. `used`: where that rest begins.
std::vector<std::vector<std::string>> csv_rows(std::string_view text, size_t& used);

}  // namespace inkbench
