// SPDX-License-Identifier: MIT
#include "studies/report/csv.h"

#include <algorithm>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

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

std::string csv_line(std::span<const std::string> fields) {
  std::string line;
  for (const std::string& field : fields) {
    if (!line.empty() || &field != fields.data()) line += ',';
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
