// SPDX-License-Identifier: MIT
#include "studies/report/csv.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

constexpr char kApostrophe = '\'';

/// Is it one number, or several as in "[-1, 0, 0]" without its brackets?
bool is_numbers(std::string_view field) {
  bool any = false;
  while (!field.empty()) {
    const size_t end = std::min(field.find_first_of(" ,"), field.size());
    std::string_view word = field.substr(0, end);
    field.remove_prefix(std::min(end + 1, field.size()));
    if (word.empty()) continue;
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [at, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc::invalid_argument || at != word.data() + word.size()) return false;
    any = true;
  }
  return any;
}

/// Behind any apostrophes stands what a formula begins with.
bool is_formula_behind_apostrophes(std::string_view field) {
  const size_t first = field.find_first_not_of(kApostrophe);
  return first != std::string_view::npos &&
         std::string_view("=+-@\t\r").find(field[first]) != std::string_view::npos;
}

/// As it is written.
std::string guarded(const std::string& field) {
  return gets_apostrophe(field) ? kApostrophe + field : field;
}

std::string unguarded(std::string field) {
  if (field.starts_with(kApostrophe) && is_formula_behind_apostrophes(field)) field.erase(0, 1);
  return field;
}

/// Takes the field at the start of `rest`, its quotes off; returns the character that ended it, 0 at the end.
char take_field(std::string_view& rest, std::string& field) {
  bool quoted = false;
  size_t at = 0;
  for (; at < rest.size(); ++at) {
    const char c = rest[at];
    if (c == '"' && quoted && at + 1 < rest.size() && rest[at + 1] == '"') {
      field += rest[++at];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == ',' || c == '\n')) {
      break;
    } else {
      field += c;
    }
  }
  field = unguarded(std::move(field));
  const char end = at < rest.size() ? rest[at] : '\0';
  rest.remove_prefix(std::min(at + 1, rest.size()));
  return end;
}

std::vector<std::string> take_row(std::string_view& rest) {
  std::vector<std::string> fields;
  char end = ',';
  while (end == ',') end = take_field(rest, fields.emplace_back());
  return fields;
}

}  // namespace

/// Of the fields that begin with apostrophes and a formula all get one more, so that each reads back as it
/// was.
bool gets_apostrophe(std::string_view field) {
  return is_formula_behind_apostrophes(field) && !is_numbers(field);
}

std::string csv_line(std::span<const std::string> fields) {
  std::string line;
  for (size_t i = 0; i < fields.size(); ++i) {
    const std::string field = guarded(fields[i]);
    if (i > 0) line += ',';
    if (field.find_first_of(",\"\r\n") == std::string::npos) {
      line += field;
      continue;
    }
    line += '"';
    for (const char c : field) line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
  }
  return line + "\n";
}

size_t CsvTable::column(std::string_view name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) throw work_error("", "the table has no column " + std::string(name));
  return static_cast<size_t>(found - columns.begin());
}

CsvTable parse_csv(std::string_view text) {
  CsvTable table;
  if (!text.empty()) table.columns = take_row(text);
  while (!text.empty()) {
    table.rows.push_back(take_row(text));
    table.rows.back().resize(table.columns.size());
  }
  return table;
}

std::vector<std::vector<std::string>> csv_rows(std::string_view text, size_t& used) {
  bool quoted = false;
  used = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;  // a doubled quote turns it twice
    if (text[i] == '\n' && !quoted) used = i + 1;
  }
  std::vector<std::vector<std::string>> rows;
  for (std::string_view rest = text.substr(0, used); !rest.empty();) rows.push_back(take_row(rest));
  return rows;
}

}  // namespace inkbench
