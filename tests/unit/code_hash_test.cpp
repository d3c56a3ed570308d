// SPDX-License-Identifier: MIT
// What a build's source hash looks at: code, and nothing else.
#include <gtest/gtest.h>

#include "scripts/code_hash/code_text.h"

namespace inkbench {
namespace {

constexpr const char* kSource = R"--(#pragma once
/// What it is.
int twice(int value) {  // doubled
  /* not
     halved */
  constexpr int kMany = 10'000;
  const char quote = '"', slash = '/';
  print("// no comment", R"(raw " /* text)");
  return 2 * value;
}
#define A 1
#define B 2
field<&P::k>({.name = "k", .help = "Old help " "in two parts.", .unit = "px"});
)--";

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = kSource;
  const size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

bool same_code(const std::string& other) {
  return code_text(kSource) == code_text(other);
}

TEST(CodeHash, comments_do_not_count) {
  EXPECT_TRUE(same_code(replaced("/// What it is.\n", "")));
  EXPECT_TRUE(same_code(replaced("// doubled", "// made twice as large")));
  EXPECT_TRUE(same_code(replaced("/* not\n     halved */", "")));
}

TEST(CodeHash, layout_does_not_count) {
  EXPECT_TRUE(same_code(replaced("\n  return", "\n\n\n    return")));
  EXPECT_TRUE(same_code(replaced("twice(int value)", "twice(\n    int value)")));
}

TEST(CodeHash, help_texts_do_not_count) {
  EXPECT_TRUE(same_code(replaced("\"Old help \" \"in two parts.\"", "\"New help.\"")));
  EXPECT_FALSE(same_code(replaced("\"px\"", "\"mm\""))) << "what follows a help text counts";
  EXPECT_FALSE(same_code(replaced("\"k\"", "\"l\"")));
}

TEST(CodeHash, code_counts) {
  EXPECT_FALSE(same_code(replaced("2 * value", "3 * value")));
  EXPECT_FALSE(same_code(replaced("10'000", "20'000")));
  EXPECT_FALSE(same_code(replaced("// no comment", "// no")));
  EXPECT_FALSE(same_code(replaced("raw \" /* text", "raw \" /* other")));
  EXPECT_FALSE(same_code(replaced("'/'", "'\\\\'")));
  EXPECT_FALSE(same_code(replaced("#define A 1\n#define B 2", "#define A 1 #define B 2")));
}

TEST(CodeHash, words_stay_apart) {
  EXPECT_NE(code_text("int a"), code_text("inta"));
  EXPECT_NE(code_text("return/**/x"), code_text("returnx"));
}

}  // namespace
}  // namespace inkbench
