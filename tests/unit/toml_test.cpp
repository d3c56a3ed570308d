// SPDX-License-Identifier: MIT
// TOML documents as trees with line numbers.
#include "pipeline/params/toml_document.h"

#include <gmock/gmock.h>

#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Kind = TomlNode::Kind;

TEST(Toml, every_kind_of_value_keeps_its_content_and_line) {
  const TomlNode document = parse_toml(
      "b = true\n"
      "i = -7\n"
      "\n"
      "r = 2.5\n"
      "t = \"text\"\n"
      "a = [1, [2]]\n"
      "o = { x = 1 }\n",
      "a.toml");
  ASSERT_EQ(document.entries.size(), 6U);
  EXPECT_EQ(document.find("b")->kind, Kind::boolean);
  EXPECT_TRUE(document.find("b")->boolean);
  EXPECT_EQ(document.find("i")->kind, Kind::integer);
  EXPECT_EQ(document.find("i")->integer, -7);
  EXPECT_EQ(document.find("r")->kind, Kind::real);
  EXPECT_EQ(document.find("r")->real, 2.5);
  EXPECT_EQ(document.find("r")->line, 4);
  EXPECT_EQ(document.find("t")->text, "text");
  EXPECT_EQ(document.find("t")->line, 5);
  ASSERT_TRUE(document.find("a")->is_array());
  EXPECT_EQ(document.find("a")->items[1].items[0].integer, 2);
  ASSERT_TRUE(document.find("o")->is_table());
  EXPECT_EQ(document.find("o")->find("x")->line, 7);
  EXPECT_EQ(document.find("none"), nullptr);
}

TEST(Toml, entries_come_in_the_order_of_their_lines) {
  const TomlNode document = parse_toml("z = 1\ny = 2\n[x]\nb = 1\na = 2\n[w]\n", "a.toml");
  std::string order;
  for (const auto& [key, node] : document.entries) order += key;
  EXPECT_EQ(order, "zyxw");
  EXPECT_EQ(document.find("x")->entries[0].key, "b");
}

TEST(Toml, dotted_keys_and_headers_make_the_same_tree) {
  for (const char* text : {"model.rabbit.size = 4", "[model]\nrabbit.size = 4", "[model.rabbit]\nsize = 4"}) {
    const TomlNode document = parse_toml(text, "a.toml");
    EXPECT_EQ(document.find("model")->find("rabbit")->find("size")->integer, 4) << text;
  }
}

TEST(Toml, grammar_errors_name_file_and_line) {
  EXPECT_THAT(error_of([] { parse_toml("a = 1\nb = \n", "a.toml"); }),
              StartsWith("a.toml:2: not valid TOML: "));
  EXPECT_THAT(error_of([] { parse_toml("a = 1\n\n[t\n", "a.toml"); }),
              StartsWith("a.toml:3: not valid TOML: "));
  EXPECT_THAT(error_of([] { parse_toml("a = \"\xff\"", "a.toml"); }),
              StartsWith("a.toml:1: not valid TOML: "));
}

TEST(Toml, a_key_given_twice_is_an_error) {
  EXPECT_THAT(error_of([] { parse_toml("a = 1\nb = 1\na = 2\n", "a.toml"); }),
              StartsWith("a.toml:3: not valid TOML: "));
  EXPECT_THAT(error_of([] { parse_toml("[t]\nx = 1\n[t]\ny = 1\n", "a.toml"); }), StartsWith("a.toml:3: "));
  EXPECT_THAT(error_of([] { parse_toml("t.x = 1\nt.x = 2\n", "a.toml"); }), StartsWith("a.toml:2: "));
  EXPECT_THAT(error_of([] { parse_toml("t = 1\nt.x = 2\n", "a.toml"); }), StartsWith("a.toml:2: "));
}

TEST(Toml, dates_and_times_are_refused) {
  for (const char* text :
       {"a = 1979-05-27", "a = 07:32:00", "a = 1979-05-27T07:32:00Z", "a = [1, 1979-05-27]"}) {
    EXPECT_THAT(error_of([&] { parse_toml(std::string("\n") + text, "a.toml"); }),
                StartsWith("a.toml:2: a date or time"));
  }
}

TEST(Toml, deep_nesting_is_an_error_and_not_a_crash) {
  std::string dots = "a";
  for (int i = 0; i < 500'000; ++i) dots += ".a";
  EXPECT_EQ(error_of([&] { parse_toml("x = 1\n" + dots + " = 1", "a.toml"); }),
            "a.toml:2: a key of too many parts; at most 16");
  EXPECT_THAT(error_of([&] { parse_toml("[" + dots + "]", "a.toml"); }), HasSubstr("too many parts"));
  EXPECT_THAT(error_of([&] { parse_toml("[[" + dots + "]]", "a.toml"); }), HasSubstr("too many parts"));
  EXPECT_THAT(error_of([&] { parse_toml("x = {" + dots + " = 1}", "a.toml"); }), HasSubstr("too many parts"));
  EXPECT_THAT(error_of([] { parse_toml("x = " + std::string(500'000, '['), "a.toml"); }),
              HasSubstr("not valid TOML"));
  std::string quoted = "'a'";
  for (int i = 0; i < 20; ++i) quoted += " . \"a\"";
  EXPECT_THAT(error_of([&] { parse_toml(quoted + " = 1", "a.toml"); }), HasSubstr("too many parts"));
}

TEST(Toml, dots_outside_of_keys_are_not_counted) {
  const std::string dots(100, '.');
  const TomlNode document = parse_toml(
      "a = \"" + dots + "\" # " + dots + "\nb = '" + dots + "'\nc = \"\"\"x\\\"\n" + dots +
          "\"\"\"\nd = '''\n" + dots +
          "'''\ne = [1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5, 0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5]\n",
      "a.toml");
  EXPECT_EQ(document.find("a")->text, dots);
  EXPECT_EQ(document.find("b")->text, dots);
  EXPECT_EQ(document.find("c")->text, "x\"\n" + dots);
  EXPECT_EQ(document.find("d")->text, dots);
  EXPECT_EQ(document.find("e")->items.size(), 17U);
}

TEST(Toml, a_node_says_what_it_is) {
  const TomlNode document =
      parse_toml("b = false\ni = 1\nr = 1.5\nt = \"x\"\na = [1, 2]\no = {}\n", "a.toml");
  EXPECT_EQ(document.find("b")->kind_name(), "false");
  EXPECT_EQ(document.find("i")->kind_name(), "a number");
  EXPECT_EQ(document.find("r")->kind_name(), "a number");
  EXPECT_EQ(document.find("t")->kind_name(), "the text \"x\"");
  EXPECT_EQ(document.find("a")->kind_name(), "a list of 2");
  EXPECT_EQ(document.find("o")->kind_name(), "a table");
}

}  // namespace
}  // namespace inkbench
