// SPDX-License-Identifier: MIT
// Text in charts: numbers as people read them, and text as gnuplot takes it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "studies/report/chart.h"

namespace inkbench {

/// The number that a field is; nothing for other text, "", nan and inf.
std::optional<double> number_in(std::string_view field);

/// Four digits at most, thousands separated, a true minus sign: "0.0125", "69,666", "−3", "1e-07".
std::string readable_number(double value);

/// The same with that many decimals.
std::string readable_number(double value, int decimals);

/// A column's field in legends and headings: numbers readable, files without folders, 0 as what it stands
/// for.
std::string readable_field(const ChartColumn& column, const std::string& field);

/// "label (unit)", or one of them where they say the same.
std::string axis_text(const ChartColumn& column);

/// One line: what is not printable becomes a space.
std::string one_line(std::string_view text);

/// A gnuplot string of that text. Quotes, '`', '@' and '\\' are written by their numbers: gnuplot loses count
/// of quotes within quotes, and would then run or replace what stands behind the other two.
std::string literal(std::string_view text);

/// A tick's label: there, gnuplot reads '%' even in a literal string.
std::string tick_literal(std::string_view text);

}  // namespace inkbench
