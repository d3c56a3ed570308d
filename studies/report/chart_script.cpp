// SPDX-License-Identifier: MIT
#include "studies/report/chart_script.h"

#include <algorithm>

#include "pipeline/base/text.h"
#include "studies/report/chart_text.h"
#include "studies/report/lettering.h"

namespace inkbench {
namespace {

constexpr const char* kAlignNames[] = {"left", "center", "right"};

std::string screen(const ChartLayout& layout, double x, double y) {
  return fmt::format("screen {:.4f},{:.4f}", x / kChartWidthPx, 1 - y / layout.height_px);
}

bool is_plain_field(const std::string& field) {
  return field.find_first_of("\"\\,\n\r\t") == std::string::npos && trim(field) == field;
}

std::vector<const ChartColumn*> columns_of(const Chart& chart) {
  std::vector<const ChartColumn*> columns{&chart.x};
  for (const ChartColumn& y : chart.y) columns.push_back(&y);
  for (const std::optional<ChartColumn>* column : {&chart.value, &chart.by, &chart.panel}) {
    if (*column) columns.push_back(&**column);
  }
  for (const ChartFilter& filter : chart.where) columns.push_back(&filter.column);
  return columns;
}

/// The text itself in the SVG; in the PNG boxes for what the font lacks, since pngcairo makes a mess of that.
template <class Literal>
std::string shown(const std::string& text, const Literal& as_literal) {
  const std::string boxed = with_boxes(text);
  return boxed == text ? as_literal(text)
                       : fmt::format("(kind eq 'svg' ? {} : {})", as_literal(text), as_literal(boxed));
}

std::string is_field(const std::string& column, const std::string& field) {
  return fmt::format("strcol({}) eq {}", literal(column), literal(field));
}

}  // namespace

void write_head(ScriptText& script, const Chart& chart) {
  write_head(script, {chart.name, chart.title, "a chart of the study \"" + chart.study + "\"", "The study"});
}

void write_head(ScriptText& script, const ScriptHead& head) {
  script.line("# {}", one_line(head.title + " (" + head.of + ")"));
  script.line("# `gnuplot {0}.gp`, run from any folder, draws {0}.svg and {0}.png beside this file.",
              head.name);
  script.line("# {} writes this file again when it runs again: to keep changes, copy it and change `name`.",
              head.writer);
  script.gap();
  script.line("name = '{}'", head.name);
  script.line("folder = ''");
  script.line("do for [i = 1:strlen(ARG0)] {{ if (ARG0[i:i] eq '/') {{ folder = ARG0[1:i] }} }}");
  script.line("if (!exists('out')) out = folder");
  script.line("if (!exists('kind')) kind = 'svg'  # the end of this file loads it again for the PNG");
  script.line("reset").line("set encoding utf8").gap();
}

void write_canvas(ScriptText& script, const ChartLayout& layout) {
  script.line(
      "if (kind eq 'svg') set terminal svg size {},{} dynamic noenhanced font 'DejaVu "
      "Sans,Verdana,sans-serif,{}' "
      "name name background '#ffffff' dashlength 0.55",
      kChartWidthPx, layout.height_px, kTickSizePx);
  script.line(
      "if (kind eq 'png') set terminal pngcairo size {},{} noenhanced font 'DejaVu Sans,{}' fontscale 0.75 "
      "background '#ffffff'",
      kChartWidthPx, layout.height_px, kTickSizePx);
  script.line("set output out.name.'.'.kind");
  script.line("mark = kind eq 'svg' ? 0.42 : 1.0  # the two count the size of points differently");
  script.line("unset key");
  script.line("set tics nomirror out textcolor rgb '#222222'");
  script.line("set multiplot");
}

void write_texts(ScriptText& script, const ChartLayout& layout) {
  for (const PlacedText& text : layout.texts) {
    script.line("set label {} at {} {}{} font ',{}' tc rgb '{}'", shown(text.text, literal),
                screen(layout, text.x, text.y), kAlignNames[static_cast<int>(text.align)],
                text.upwards ? " rotate by 90" : "", text.size_px, text.colour);
  }
  int style = 0;
  for (const auto& [x, y] : layout.legend_marks) {
    ++style;
    script.line("set arrow from {} to {} nohead ls {}", screen(layout, x, y),
                screen(layout, x + kLegendMarkPx, y), style);
    script.line("set label '' at {} point ls {}", screen(layout, x + kLegendMarkPx / 2.0, y), style);
  }
}

void set_headings(LayoutNeeds& needs, const Chart& chart, const std::vector<std::string>& panels) {
  const bool has_panels = chart.panel && !(panels.size() == 1 && panels.front().empty());
  if (has_panels && !chart.panel->names_itself) needs.panel_label = one_line(axis_text(*chart.panel));
  for (const std::string& field : panels)
    needs.headings.push_back(has_panels ? readable_field(*chart.panel, field) : "");
}

void write_panel_place(ScriptText& script, const ChartLayout& layout, size_t panel) {
  const ChartBox& box = layout.panels[panel];
  script.line("set lmargin at screen {:.4f}; set rmargin at screen {:.4f}", box.left / kChartWidthPx,
              box.right / kChartWidthPx);
  script.line("set tmargin at screen {:.4f}; set bmargin at screen {:.4f}", 1 - box.top / layout.height_px,
              1 - box.bottom / layout.height_px);
}

void write_ticks(ScriptText& script, const char* axis, const ChartAxis& description, bool with_labels) {
  if (description.ticks.empty()) {
    script.line("unset {}tics", axis);  // an empty list would stand for gnuplot's own
    return;
  }
  std::vector<std::string> ticks;
  for (const ChartTick& tick : description.ticks)
    ticks.push_back(fmt::format("{} {:.12g}", shown(with_labels ? tick.label : "", tick_literal), tick.at));
  for (const double at : description.minor) ticks.push_back(fmt::format("'' {:.12g} 1", at));
  script.line("set {}tics ({})", axis, join(ticks, ", "));
}

std::string range_text(const ChartAxis& axis) {
  return fmt::format("[{:.9g}:{:.9g}]", axis.low, axis.high);
}

void write_foot(ScriptText& script) {
  script.line("unset multiplot");
  script.line("unset output").gap();
  script.line("kind = kind eq 'svg' ? 'png' : 'done'");
  script.line("if (kind eq 'png') load ARG0");
}

bool is_plain(const CsvTable& table, const Chart& chart) {
  for (const std::vector<std::string>& row : table.rows) {
    if (std::any_of(row.begin(), row.end(), [](const std::string& field) {
          return field.find_first_of("\"\\\n\r") != std::string::npos || gets_apostrophe(field);
        }))
      return false;
  }
  for (const ChartColumn* column : columns_of(chart)) {
    const size_t index = table.column(column->name);
    if (!is_plain_field(column->name)) return false;
    for (const std::vector<std::string>& row : table.rows) {
      if (!is_plain_field(row[index])) return false;
    }
  }
  return true;
}

void write_data_source(ScriptText& script, const std::string& table) {
  script.line("data = folder.'../{}'", table);
  script.line("set datafile separator ','");
  script.line("set datafile columnheaders");
  script.line(
      "number(column_name) = strlen(strcol(column_name)) ? column(column_name) : NaN  # an empty field is a "
      "gap");
}

std::string row_condition(const Chart& chart, const std::string& panel, const std::string& by) {
  std::vector<std::string> parts;
  if (chart.panel) parts.push_back(is_field(chart.panel->name, panel));
  if (chart.by) parts.push_back(is_field(chart.by->name, by));
  for (const ChartFilter& filter : chart.where) {
    std::vector<std::string> choices;
    for (const std::string& field : filter.fields) choices.push_back(is_field(filter.column.name, field));
    parts.push_back(choices.size() == 1 ? choices.front() : "(" + join(choices, " || ") + ")");
  }
  parts.push_back("strcol('error') eq ''");
  return join(parts, " && ");
}

std::vector<std::string> choice_notes(const Chart& chart) {
  std::vector<std::string> parts;
  for (const ChartFilter& filter : chart.where) {
    std::vector<std::string> fields;
    for (const std::string& field : filter.fields) fields.push_back(readable_field(filter.column, field));
    parts.push_back(filter.column.label + " = " + join(fields, " or "));
  }
  std::vector<std::string> notes;
  if (!parts.empty()) notes.push_back("Only cells with " + join(parts, " and ") + ".");
  if (chart.best_of) {
    notes.push_back(fmt::format("Each {} is the cell with the {} {}.",
                                chart.kind == ChartKind::lines ? "point" : "place",
                                chart.best_of_least ? "least" : "greatest", chart.best_of->label));
  }
  return notes;
}

std::string chart_script(const Chart& chart, const CsvTable& table) {
  return chart.kind == ChartKind::lines ? lines_script(chart, table) : heatmap_script(chart, table);
}

}  // namespace inkbench
