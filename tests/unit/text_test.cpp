// SPDX-License-Identifier: MIT
// Numbers that read back exactly, counts with commas, lists, and the nearest name.
#include "pipeline/base/text.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace inkbench {
namespace {

template <class T>
T read_back(const std::string& text) {
  T value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_EQ(result.ptr, text.data() + text.size()) << text;
  return value;
}

TEST(Shortest, writes_decimals_as_people_do) {
  EXPECT_EQ(shortest(0.003F), "0.003");
  EXPECT_EQ(shortest(0.0125F), "0.0125");
  EXPECT_EQ(shortest(1e-6F), "1e-06");
  EXPECT_EQ(shortest(20.0F), "20");
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(1.0 / 3.0), "0.3333333333333333");
}

TEST(Shortest, negative_zero_and_zero_have_one_text) {
  EXPECT_EQ(shortest(-0.0F), "0");
  EXPECT_EQ(shortest(-0.0), "0");
  EXPECT_EQ(shortest(0.0F), "0");
}

TEST(Shortest, every_float_reads_back_the_same) {
  std::mt19937 random(1);
  for (int i = 0; i < 200'000; ++i) {
    const auto value = std::bit_cast<float>(static_cast<uint32_t>(random()));
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(read_back<float>(shortest(value)), value) << shortest(value);
  }
}

TEST(Shortest, every_double_reads_back_the_same) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 100'000; ++i) {
    const auto value = std::bit_cast<double>(static_cast<uint64_t>(random()));
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(read_back<double>(shortest(value)), value) << shortest(value);
  }
}

TEST(Shortest, the_extremes_read_back_the_same) {
  using Float = std::numeric_limits<float>;
  for (const float value :
       {Float::min(), Float::max(), Float::lowest(), Float::denorm_min(), Float::epsilon()}) {
    EXPECT_EQ(read_back<float>(shortest(value)), value);
  }
}

TEST(WithCommas, separates_thousands) {
  EXPECT_EQ(with_commas(0), "0");
  EXPECT_EQ(with_commas(999), "999");
  EXPECT_EQ(with_commas(1000), "1,000");
  EXPECT_EQ(with_commas(69666), "69,666");
  EXPECT_EQ(with_commas(100'000), "100,000");
  EXPECT_EQ(with_commas(1'234'567), "1,234,567");
}

TEST(WithCommas, keeps_the_sign_out_of_the_groups) {
  EXPECT_EQ(with_commas(-1), "-1");
  EXPECT_EQ(with_commas(-123), "-123");
  EXPECT_EQ(with_commas(-123'456), "-123,456");
  EXPECT_EQ(with_commas(std::numeric_limits<long long>::min()), "-9,223,372,036,854,775,808");
}

TEST(ReadableBytes, picks_the_unit_by_size) {
  EXPECT_EQ(readable_bytes(0), "0 bytes");
  EXPECT_EQ(readable_bytes(12), "12 bytes");
  EXPECT_EQ(readable_bytes(999), "999 bytes");
  EXPECT_EQ(readable_bytes(1234), "1.2 kB");
  EXPECT_EQ(readable_bytes(45'600), "46 kB");
  EXPECT_EQ(readable_bytes(812'000), "812 kB");
  EXPECT_EQ(readable_bytes(999'999), "1.0 MB");
  EXPECT_EQ(readable_bytes(3.14e6), "3.1 MB");
  EXPECT_EQ(readable_bytes(2.5e9), "2.5 GB");
}

TEST(Split, keeps_empty_parts_and_join_undoes_it) {
  EXPECT_EQ(split("a,,b,", ','), (std::vector<std::string>{"a", "", "b", ""}));
  EXPECT_EQ(split("", ','), std::vector<std::string>{""});
  EXPECT_EQ(split("abc", ','), std::vector<std::string>{"abc"});
  EXPECT_EQ(join(split("a,,b,", ','), ","), "a,,b,");
  EXPECT_EQ(join({}, ", "), "");
}

TEST(Trim, removes_white_space_at_both_ends_only) {
  EXPECT_EQ(trim("  a b \t\r\n"), "a b");
  EXPECT_EQ(trim(" \n "), "");
  EXPECT_EQ(trim(""), "");
  EXPECT_EQ(trim("x"), "x");
}

const std::vector<std::string> kKeys{"combine.k_depth", "combine.k_normal", "combine.threshold"};

TEST(NearestName, finds_a_name_with_a_few_letters_wrong) {
  EXPECT_EQ(nearest_name("combine.k_dpeth", kKeys), "combine.k_depth");
  EXPECT_EQ(nearest_name("combine.kdepth", kKeys), "combine.k_depth");
  EXPECT_EQ(nearest_name("combine.k_norml", kKeys), "combine.k_normal");
}

TEST(NearestName, finds_nothing_where_nothing_is_near) {
  EXPECT_EQ(nearest_name("camera", kKeys), "");
  EXPECT_EQ(nearest_name("xyz", std::vector<std::string>{"box"}), "");
  EXPECT_EQ(nearest_name("anything", {}), "");
}

TEST(NearestName, an_exact_name_wins_over_a_near_one) {
  EXPECT_EQ(nearest_name("abd", std::vector<std::string>{"abc", "abd", "abe"}), "abd");
}

TEST(Suggest, names_the_nearest_one) {
  EXPECT_EQ(suggest("combine.k_deth", kKeys), "did you mean 'combine.k_depth'?");
}

TEST(Suggest, lists_few_candidates_and_says_nothing_of_many) {
  EXPECT_EQ(suggest("zzzzzz", std::vector<std::string>{"box", "sphere"}), "one of: box, sphere");
  EXPECT_EQ(suggest("zzzzzz", std::vector<std::string>(17, "a name far away")), "");
  EXPECT_EQ(suggest("zzzzzz", {}), "");
}

TEST(Text, lower_case_leaves_letters_beyond_ascii) {
  EXPECT_EQ(lower_case(".PnG [@Z`{ \xc3\x84"), ".png [@z`{ \xc3\x84");
}

TEST(Text, tells_utf8_from_other_bytes) {
  for (const char* text :
       {"", "plain", "\xc3\xa4", "\xe2\x82\xac", "\xf0\x9f\x90\x87", "\xef\xbf\xbf", "\xf4\x8f\xbf\xbf"})
    EXPECT_TRUE(is_utf8(text)) << text;
  EXPECT_TRUE(is_utf8(std::string_view("a\0b", 3)));
  for (const char* text : {"\x80", "\xc3", "\xc3(", "\xe2\x82", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80",
                           "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80", "\xff", "ok\xe4"})
    EXPECT_FALSE(is_utf8(text)) << text;
}

TEST(Text, printable_text_moves_no_cursor) {
  EXPECT_EQ(printable("caf\xc3\xa9 \xe2\x82\xac plain"), "caf\xc3\xa9 \xe2\x82\xac plain");
  EXPECT_EQ(printable("\x1b[31mred\x07"), "\\u001b[31mred\\u0007");
  EXPECT_EQ(printable("a\xc2\x9b"
                      "2J"),
            "a\\u009b2J")
      << "the one-character start of a control sequence";
  EXPECT_EQ(printable("a\x9b"
                      "2J\xff"),
            "a\\x9b2J\\xff")
      << "no UTF-8";
  EXPECT_EQ(printable("a\xe2\x80\xae"
                      "b"),
            "a\\u202eb")
      << "turned around";
  EXPECT_EQ(printable("a\r\nb\tc"), "a\\u000d\\u000ab\\u0009c");
  EXPECT_EQ(printable("a\r\nb\tc", true), "a\\u000d\nb\tc");
}

}  // namespace
}  // namespace inkbench
