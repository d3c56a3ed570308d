// Rows of CSV: quoted where RFC 4180 asks for it, and only there.
#include "studies/report/csv.h"

#include <gtest/gtest.h>

#include <vector>

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

}  // namespace
}  // namespace inkbench
