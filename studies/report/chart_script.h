// SPDX-License-Identifier: MIT
// The parts that the scripts of all charts share. In: a chart, its layout and axes. Out: lines of gnuplot.
#pragma once

#include <fmt/format.h>

#include <string>

#include "studies/report/chart_axis.h"
#include "studies/report/chart_data.h"
#include "studies/report/chart_layout.h"

namespace inkbench {

/// Grows line by line.
class ScriptText {
 public:
  template <class... Arguments>
  ScriptText& line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    text_ += fmt::format(format, std::forward<Arguments>(arguments)...) + "\n";
    return *this;
  }
  ScriptText& gap() { return line(""); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// What the chart is, how to draw it again, and where its files lie. `of` says whose chart it is, `writer`
/// who writes the script again ("The study").
struct ScriptHead {
  std::string name, title, of, writer;
};
void write_head(ScriptText& script, const ScriptHead& head);
void write_head(ScriptText& script, const Chart& chart);

/// Both kinds of picture and what lies under every plot.
void write_canvas(ScriptText& script, const ChartLayout& layout);

/// The texts of the layout, which the next plot draws.
void write_texts(ScriptText& script, const ChartLayout& layout);

/// The panels' headings: none without a column for them, or without a row.
void set_headings(LayoutNeeds& needs, const Chart& chart, const std::vector<std::string>& panels);

/// The place of one panel on the paper.
void write_panel_place(ScriptText& script, const ChartLayout& layout, size_t panel);

/// "set xtics (...)": with labels, or only their places.
void write_ticks(ScriptText& script, const char* axis, const ChartAxis& description, bool with_labels);

/// "[low:high]" as a range's text.
std::string range_text(const ChartAxis& axis);

/// Ends a picture and, after the first one, draws the second.
void write_foot(ScriptText& script);

/// Whether gnuplot reads the table's rows as we do: it knows no quotes within fields and takes '\' for an
/// escape, and the names and fields that the script compares must stand there as they are.
bool is_plain(const CsvTable& table, const Chart& chart);

/// Opens the table's file in the script, so that column('f1') and strcol('f1') work.
void write_data_source(ScriptText& script, const std::string& table);

/// The condition in gnuplot that picks the chart's rows, all of which worked; "" where all count. `panel` and
/// `by` are fields.
std::string row_condition(const Chart& chart, const std::string& panel, const std::string& by);

/// What a reader must know beyond the axes: filters, the choice of best rows.
std::vector<std::string> choice_notes(const Chart& chart);

std::string lines_script(const Chart& chart, const CsvTable& table);
std::string heatmap_script(const Chart& chart, const CsvTable& table);

}  // namespace inkbench
