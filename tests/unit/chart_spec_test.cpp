// SPDX-License-Identifier: MIT
// [[chart]] in a study's spec: what is left out is filled in from the columns; what data.csv cannot fill is
// an error with file and line.
#include <gmock/gmock.h>

#include <map>

#include "studies/sweep/data_columns.h"
#include "studies/sweep/spec.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// A study of 3 x 2 x 2 cells; 14 lines.
const std::string kStudy =
    "title = \"S\"\n"
    "measure = [\"f1\", \"chamfer\", \"empty\"]\n"
    "[[axis]]\n"
    "key = \"mesh.faces\"\n"
    "label = \"triangles\"\n"
    "values = [0, 1000, 100]\n"
    "[[axis]]\n"
    "key = \"mesh.normals\"\n"
    "label = \"vertex normals\"\n"
    "values = [\"smooth\", \"flat\"]\n"
    "[[axis]]\n"
    "key = \"combine.k_normal\"\n"
    "values = [0.01, 0.02]\n"
    "[[chart]]\n";
constexpr int kLines = 14;

Chart chart(const std::string& body) {
  return parse_spec(kStudy + body, "/studies/s.toml", {}).charts.at(0);
}

std::string chart_error(const std::string& body) {
  return error_of([&] { chart(body); });
}

std::string at_line(int line, const std::string& message) {
  return "/studies/s.toml:" + std::to_string(kLines + line) + ": " + message;
}

const std::string kGood =
    "x = \"mesh.faces\"\ny = \"f1\"\nby = \"mesh.normals\"\npanel = \"combine.k_normal\"\n";

TEST(ChartSpec, a_study_without_charts_has_none) {
  EXPECT_TRUE(parse_spec("", "/studies/s.toml", {}).charts.empty());
}

TEST(ChartSpec, what_is_left_out_comes_from_the_columns) {
  const Chart lines = chart(kGood);
  EXPECT_EQ(lines.kind, ChartKind::lines);
  EXPECT_EQ(lines.title, "f1 against triangles");
  EXPECT_EQ(lines.name, "f1_against_triangles");
  EXPECT_EQ(lines.study, "S");
  EXPECT_EQ(lines.x_label, "triangles");
  EXPECT_EQ(lines.y_label, "f1");
  EXPECT_EQ(lines.scale_x, Scale::log) << "as the parameter's";
  EXPECT_EQ(lines.scale_y, Scale::linear);
  EXPECT_EQ(lines.x.zero, "as loaded");
  EXPECT_TRUE(lines.by->is_text);
  EXPECT_EQ(lines.by->label, "vertex normals");
  EXPECT_EQ(lines.panel->label, "k_normal");
  EXPECT_FALSE(lines.y_from.has_value());
  const Chart best =
      chart("x = \"mesh.faces\"\ny = \"combine.k_normal\"\nby = \"mesh.normals\"\nbest_of = \"chamfer\"\n");
  EXPECT_EQ(best.scale_y, Scale::log);
  EXPECT_TRUE(best.best_of_least) << "of distances, the least is best";
  EXPECT_FALSE(chart("x = \"mesh.faces\"\ny = \"f1\"\nbest_of = \"f1\"\n").best_of_least);
}

TEST(ChartSpec, heat_maps_have_their_own_entries) {
  const Chart heat = chart(
      "kind = \"heatmap\"\nx = \"mesh.faces\"\ny = \"mesh.normals\"\nvalue = \"chamfer\"\npanel = "
      "\"combine.k_normal\"\n");
  EXPECT_EQ(heat.kind, ChartKind::heatmap);
  EXPECT_EQ(heat.value_label, "chamfer distance (px)");
  EXPECT_EQ(heat.title, "chamfer distance over triangles and vertex normals");
  EXPECT_TRUE(heat.mark_least);
}

TEST(ChartSpec, entries_are_taken) {
  const Chart taken = chart(
      "name = \"a-1_b\"\ntitle = \"T\"\nx = \"mesh.faces\"\ny = [\"f1\", \"ink\"]\nx_label = \"X\"\ny_label "
      "= \"Y\"\n"
      "scale_x = \"linear\"\nscale_y = \"log\"\ny_from = 0.5\ny_to = 2\nbest_of = \"f1\"\nbest = \"least\"\n"
      "where = { mesh.normals = \"flat\", combine.k_normal = [0.01, 0.02], empty = false }\n");
  EXPECT_EQ(taken.name, "a-1_b");
  EXPECT_EQ(taken.title, "T");
  EXPECT_EQ(taken.y.size(), 2U);
  EXPECT_EQ(taken.x_label, "X");
  EXPECT_EQ(taken.y_label, "Y");
  EXPECT_EQ(taken.scale_x, Scale::linear);
  EXPECT_EQ(taken.scale_y, Scale::log);
  EXPECT_EQ(taken.y_from, 0.5);
  EXPECT_EQ(taken.y_to, 2);
  EXPECT_TRUE(taken.best_of_least);
  ASSERT_EQ(taken.where.size(), 3U);
  std::map<std::string, std::vector<std::string>> filters;
  for (const ChartFilter& filter : taken.where) filters[filter.column.name] = filter.fields;
  EXPECT_THAT(filters["mesh.normals"], ElementsAre("flat"));
  EXPECT_THAT(filters["combine.k_normal"], ElementsAre("0.01", "0.02"));
  EXPECT_THAT(filters["empty"], ElementsAre("false"));
  EXPECT_EQ(chart(kGood + "where = { \"mesh.normals\" = \"flat\" }\n").where[0].column.name, "mesh.normals");
}

TEST(ChartSpec, columns_must_be_those_of_the_table) {
  EXPECT_EQ(chart_error("x = \"mesh.face\"\ny = \"f1\"\n"),
            at_line(1, "data.csv will have no column 'mesh.face'; did you mean 'mesh.faces'?"));
  EXPECT_EQ(chart_error("x = \"mesh.faces\"\ny = \"recall\"\n"),
            at_line(2, "data.csv will have no column 'recall'; add it to the study's measure"));
  EXPECT_THAT(chart_error("x = \"variant\"\ny = \"f1\"\n"),
              StartsWith(at_line(1, "data.csv will have no column 'variant'")));
  EXPECT_THAT(chart_error("x = \"error\"\ny = \"f1\"\n"),
              StartsWith(at_line(1, "data.csv will have no column 'error'")));
  EXPECT_THAT(chart_error("x = \"mesh.faces\"\ny = \"mesh.normals\"\n"),
              StartsWith(at_line(2, "y is \"mesh.normals\", which holds no numbers")));
  EXPECT_THAT(chart_error("x = \"mesh.faces\"\ny = [\"f1\", \"f1\"]\n"),
              StartsWith(at_line(2, "y names f1 twice")));
  EXPECT_THAT(chart_error("x = \"mesh.faces\"\ny = []\n"), StartsWith(at_line(2, "y is an empty list")));
  EXPECT_THAT(chart_error("x = 1\ny = \"f1\"\n"), StartsWith(at_line(1, "x is a number; it must be text")));
  EXPECT_THAT(chart_error("y = \"f1\"\n"), StartsWith(at_line(0, "a [[chart]] without x")));
  EXPECT_THAT(chart_error("x = \"mesh.faces\"\n"), StartsWith(at_line(0, "a [[chart]] without y")));
  EXPECT_THAT(chart_error("x = \"mesh.faces\"\ny = \"f1\"\nby = \"mesh.faces\"\n"),
              StartsWith(at_line(3, "by and x are both mesh.faces")));
  EXPECT_THAT(chart_error("kind = \"heatmap\"\nx = \"mesh.faces\"\ny = \"f1\"\nvalue = \"f1\"\n"),
              StartsWith(at_line(3, "y of a heat map is f1, which is measured")));
}

TEST(ChartSpec, entries_must_be_known_and_fit_their_kind) {
  EXPECT_EQ(chart_error(kGood + "titel = \"x\"\n"),
            at_line(5, "unknown entry 'titel'; did you mean 'title'?"));
  EXPECT_EQ(chart_error(kGood + "value = \"f1\"\n"),
            at_line(5, "value is not for a chart of lines; add kind = \"heatmap\", or leave it out"));
  EXPECT_EQ(chart_error("kind = \"heatmap\"\nscale_x = \"log\"\n"),
            at_line(2, "scale_x is not for a heat map; leave it out"));
  EXPECT_EQ(chart_error(kGood + "kind = \"bars\"\n"), at_line(5, "kind is \"bars\"; one of: lines, heatmap"));
  EXPECT_EQ(chart_error(kGood + "scale_y = \"cubic\"\n"),
            at_line(5, "scale_y is \"cubic\"; one of: linear, log"));
  EXPECT_EQ(chart_error(kGood + "y_from = \"0\"\n"),
            at_line(5, "y_from is the text \"0\"; it must be a finite number"));
  EXPECT_EQ(chart_error(kGood + "y_from = nan\n"),
            at_line(5, "y_from is a number; it must be a finite number"));
  EXPECT_EQ(chart_error(kGood + "y_from = 1\ny_to = 1\n"), at_line(6, "y_to = 1; it must be above y_from"));
  EXPECT_EQ(chart_error(kGood + "scale_y = \"log\"\ny_from = 0\n"),
            at_line(6, "y_from = 0 on a log axis; it must be above 0"));
  EXPECT_THAT(chart_error(kGood + "best = \"least\"\n"), StartsWith(at_line(5, "best without best_of")));
  EXPECT_THAT(chart_error("x = \"mesh.normals\"\ny = \"f1\"\nscale_x = \"log\"\n"),
              StartsWith(at_line(3, "scale_x over mesh.normals, which holds names")));
  EXPECT_EQ(error_of([] { parse_spec("chart = 1", "/studies/s.toml", {}); }),
            "/studies/s.toml:1: chart is a number; it must be tables: [[chart]]");
}

TEST(ChartSpec, names_are_file_names_and_differ) {
  for (const char* name : {"", "A", "a b", "../a", "a/b", ".", "\u00e4"})
    EXPECT_THAT(chart_error(kGood + "name = \"" + name + "\"\n"), HasSubstr("it names files"));
  EXPECT_THAT(chart_error(kGood + "name = \"" + std::string(65, 'a') + "\"\n"), HasSubstr("it names files"));
  EXPECT_EQ(
      chart_error(kGood + "[[chart]]\n" + kGood),
      at_line(
          5, "chart f1_against_triangles: a second chart of that name; give it another one: name = \"...\""));
  EXPECT_EQ(chart(kGood + "title = \"  F1: what?! \u00e4\"\n").name, "f1_what");
  EXPECT_EQ(chart(kGood + "title = \"\u65e5\u672c\"\n").name, "chart");
}

TEST(ChartSpec, filters_name_values_that_cells_have) {
  EXPECT_EQ(chart_error(kGood + "where = { mesh.faces = 500 }\n"),
            at_line(0, "chart f1_against_triangles: no cell has mesh.faces = 500; did you mean '100'?"));
  EXPECT_THAT(chart_error(kGood + "where = { mesh.normals = \"flt\" }\n"),
              AllOf(StartsWith(at_line(5, "")), HasSubstr("flat")));
  EXPECT_THAT(chart_error(kGood + "where = { mesh.normals = 1 }\n"), StartsWith(at_line(5, "")));
  EXPECT_THAT(chart_error(kGood + "where = { mesh.normls = \"flat\" }\n"),
              StartsWith(at_line(5, "data.csv will have no column 'mesh.normls'")));
  EXPECT_THAT(chart_error(kGood + "where = { mesh.normals = [] }\n"),
              StartsWith(at_line(5, "where lists no value")));
  EXPECT_THAT(chart_error(kGood + "where = 1\n"),
              StartsWith(at_line(5, "where is a number; it must be a table")));
}

TEST(ChartSpec, cells_that_would_fall_together_are_an_error) {
  EXPECT_THAT(
      chart_error("x = \"mesh.faces\"\ny = \"f1\"\n"),
      AllOf(StartsWith(at_line(
                0, "chart f1_against_triangles: cells 1 and 4 stand at the same place (mesh.faces = 0)")),
            HasSubstr("by or panel")));
}

TEST(ChartSpec, a_vector_in_where_is_one_value) {
  const StudySpec spec = parse_spec(
      "[[axis]]\nkey = \"light.key.direction\"\nvalues = [[1, 1, 1], [-1, 1, 1]]\n[[chart]]\nx = \"cell\"\ny "
      "= \"ink\"\n"
      "where = { light.key.direction = [1, 1, 1] }\n[[chart]]\nname = \"b\"\nx = \"cell\"\ny = \"ink\"\n"
      "where = { light.key.direction = [[1, 1, 1], [-1, 1, 1]] }\n",
      "/studies/s.toml", {});
  EXPECT_THAT(spec.charts.at(0).where.at(0).fields, ElementsAre("[1, 1, 1]"));
  EXPECT_THAT(spec.charts.at(1).where.at(0).fields, ElementsAre("[1, 1, 1]", "[-1, 1, 1]"));
}

TEST(ChartSpec, variants_are_a_column) {
  const StudySpec spec = parse_spec(
      "[[variant]]\nname = \"a\"\n[variant.set]\ncombine.k_depth = 0.5\n[[variant]]\nname = "
      "\"b\"\n[[chart]]\n"
      "x = \"variant\"\ny = \"ink\"\nwhere = { variant = [\"a\", \"b\"] }\n",
      "/studies/s.toml", {});
  EXPECT_TRUE(spec.charts.at(0).x.is_text);
  const CsvTable planned = planned_table(spec);
  EXPECT_THAT(planned.columns, ElementsAre("cell", "variant", "combine.k_depth", "ink", "ink_px"));
  EXPECT_THAT(planned.rows,
              ElementsAre(ElementsAre("1", "a", "0.5", "", ""), ElementsAre("2", "b", "0.003", "", "")));
}

TEST(ChartSpec, every_measure_has_a_label) {
  const StudySpec spec = parse_spec("measure = true\n", "/studies/s.toml", {});
  for (const ChartColumn& column : chart_columns(spec)) {
    EXPECT_FALSE(column.label.empty()) << column.name;
    EXPECT_EQ(column.label.find('_'), std::string::npos) << column.name;
  }
}

}  // namespace
}  // namespace inkbench
