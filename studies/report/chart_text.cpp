// SPDX-License-Identifier: MIT
#include "studies/report/chart_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>

namespace inkbench {
namespace {

constexpr double kGreatest = 1e300;  // Beyond it, the span of two numbers may be none.
constexpr std::string_view kMinus = "\u2212";

/// `digits` is a number without sign in plain notation.
std::string with_separators(const std::string& digits, bool negative) {
  const size_t point = std::min(digits.find('.'), digits.size());
  std::string whole = digits.substr(0, point);
  for (size_t end = whole.size(); end > 3; end -= 3) whole.insert(end - 3, ",");
  return (negative ? std::string(kMinus) : "") + whole + digits.substr(point);
}

bool is_zero(const std::string& digits) {
  return digits.find_first_not_of("0.") == std::string::npos;
}

}  // namespace

std::optional<double> number_in(std::string_view field) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  const bool whole = error == std::errc() && end == field.data() + field.size();
  if (!whole || !(std::abs(value) < kGreatest)) return std::nullopt;
  return std::abs(value) < 1 / kGreatest ? 0 : value;
}

std::string readable_number(double value) {
  const double size = std::abs(value);
  if (size == 0) return "0";
  if (size == std::floor(size) && size < 1e9) return readable_number(value, 0);
  if (size < 1e-5 || size >= 1e9) return (value < 0 ? std::string(kMinus) : "") + fmt::format("{:.4g}", size);
  const int decimals = std::max(0, 3 - static_cast<int>(std::floor(std::log10(size))));
  std::string digits = fmt::format("{:.{}f}", size, decimals);
  if (decimals > 0) digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return with_separators(digits, value < 0);
}

std::string readable_number(double value, int decimals) {
  if (std::abs(value) >= 1e9)
    return (value < 0 ? std::string(kMinus) : "") + fmt::format("{:.4g}", std::abs(value));
  const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
  return with_separators(digits, value < 0 && !is_zero(digits));
}

std::string readable_field(const ChartColumn& column, const std::string& field) {
  const std::optional<double> number = number_in(field);
  if (number && *number == 0 && !column.zero.empty()) return column.zero;
  if (number && !column.is_text) return readable_number(*number);
  if (field.empty()) return "none";
  if (const auto label = column.field_labels.find(field); label != column.field_labels.end())
    return one_line(label->second);
  return one_line(field.front() == '/' ? std::filesystem::path(field).filename().string() : field);
}

std::string axis_text(const ChartColumn& column) {
  const bool says_it = column.unit.empty() || column.label.find(column.unit) != std::string::npos;
  return says_it ? column.label : column.label + " (" + column.unit + ")";
}

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return line;
}

std::string literal(std::string_view text) {
  constexpr std::string_view kSpecial = "'\"`@\\";
  const std::string line = one_line(text);
  if (line.find_first_of(kSpecial) == std::string::npos) return "'" + line + "'";
  std::string escaped;
  for (const char c : line)
    escaped += kSpecial.find(c) == std::string_view::npos ? std::string(1, c) : fmt::format("\\{:03o}", c);
  return '"' + escaped + '"';
}

std::string tick_literal(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '%' ? std::string("%%") : std::string(1, c);
  return literal(escaped);
}

}  // namespace inkbench
