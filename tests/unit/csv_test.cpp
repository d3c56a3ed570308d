// SPDX-License-Identifier: MIT
// Rows of CSV: quoted where RFC 4180 asks for it, and only there.
#include "studies/report/csv.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/unit/support.h"

namespace inkbench {
namespace {

std::string line_of(const std::vector<std::string>& fields) {
  return csv_line(fields);
}

TEST(Csv, plain_fields_stand_as_they_are) {
  EXPECT_EQ(line_of({"cell", "0.003", "a b", "it's"}), "cell,0.003,a b,it's\n");
}

TEST(Csv, empty_fields_keep_their_place) {
  EXPECT_EQ(line_of({"", "a", "", ""}), ",a,,\n");
  EXPECT_EQ(line_of({"", ""}), ",\n");
  EXPECT_EQ(line_of({""}), "\n");
}

TEST(Csv, commas_quotes_and_line_breaks_are_quoted) {
  EXPECT_EQ(line_of({"a,b"}), "\"a,b\"\n");
  EXPECT_EQ(line_of({"say \"no\""}), "\"say \"\"no\"\"\"\n");
  EXPECT_EQ(line_of({"two\nlines"}), "\"two\nlines\"\n");
  EXPECT_EQ(line_of({"carriage\rreturn"}), "\"carriage\rreturn\"\n");
  EXPECT_EQ(line_of({"\""}), "\"\"\"\"\n");
}

TEST(Csv, a_quoted_field_does_not_touch_its_neighbours) {
  EXPECT_EQ(line_of({"a", "b,c", "d"}), "a,\"b,c\",d\n");
}

TEST(Csv, what_was_written_reads_back) {
  const std::vector<std::string> head{"a", "b,c", "d"};
  const std::vector<std::string> rows[] = {
      {"1", "", "x"}, {"say \"no\"", "two\nlines", "\"\""}, {"", "", ""}};
  std::string text = line_of(head);
  for (const std::vector<std::string>& row : rows) text += line_of(row);
  const CsvTable table = parse_csv(text);
  EXPECT_EQ(table.columns, head);
  ASSERT_EQ(table.rows.size(), 3U);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(table.rows[i], rows[i]);
}

TEST(Csv, damaged_text_reads_as_whole_rows) {
  EXPECT_TRUE(parse_csv("").columns.empty());
  const CsvTable table = parse_csv("a,b\n1\n1,2,3\n\"open, 5");
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"1", ""}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(table.rows[2], (std::vector<std::string>{"open, 5", ""}));
}

TEST(Csv, rows_that_are_still_written_wait_for_their_end) {
  size_t used = 0;
  const std::string text = "a,b\n\"two\nlines\",\"x\"\"y\"\n1,\"half\n";
  const auto rows = csv_rows(text, used);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1], (std::vector<std::string>{"two\nlines", "x\"y"}));
  EXPECT_EQ(text.substr(used), "1,\"half\n");
}

TEST(Csv, a_column_is_found_by_its_name) {
  const CsvTable table = parse_csv("f1,f1_t1\n");
  EXPECT_EQ(table.column("f1_t1"), 1U);
  EXPECT_EQ(error_of([&] { table.column("f"); }, ErrorKind::work), "the table has no column f");
}

TEST(Csv, text_that_a_spreadsheet_would_take_for_a_formula_is_guarded_and_numbers_are_not) {
  const auto written = [](const std::string& field) {
    const std::string line = csv_line(std::array{field});
    return line.substr(0, line.size() - 1);
  };
  EXPECT_EQ(written("=1+1"), "'=1+1");
  EXPECT_EQ(written("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(written("+cmd|' /C calc'!A0"), "'+cmd|' /C calc'!A0");
  EXPECT_EQ(written("-2+3"), "'-2+3");
  EXPECT_EQ(written("-"), "'-");
  EXPECT_EQ(written("=HYPERLINK(\"x\",\"y\")"), "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"");
  for (const char* number : {"-0.5", "+1", "-1e-07", "-inf", "-nan", "0", "-1 0 0.5"})
    EXPECT_EQ(written(number), number);
}

TEST(Csv, guarded_fields_read_back_as_they_were) {
  for (const std::string field : {"=1", "'=1", "''=1", "'x", "'", "-0.5", "'-0.5", "\t=", "", "a=b"}) {
    size_t used = 0;
    EXPECT_EQ(csv_rows(csv_line(std::array{field, field}), used)[0], (std::vector{field, field})) << field;
  }
}

}  // namespace
}  // namespace inkbench
