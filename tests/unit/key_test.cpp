// SPDX-License-Identifier: MIT
// Keys: what differs gets another key, whichever way it is cut into parts.
#include "pipeline/base/key.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace inkbench {
namespace {

Key key_of(const std::vector<std::string>& parts) {
  KeyBuilder builder;
  for (const std::string& part : parts) builder.add(part);
  return builder.key();
}

TEST(Key, same_parts_give_the_same_key) {
  EXPECT_EQ(key_of({"combine", "0.003"}), key_of({"combine", "0.003"}));
}

TEST(Key, the_same_letters_cut_elsewhere_give_another_key) {
  EXPECT_NE(key_of({"ab", "c"}), key_of({"a", "bc"}));
  EXPECT_NE(key_of({"abc"}), key_of({"abc", ""}));
  EXPECT_NE(key_of({"", "abc"}), key_of({"abc", ""}));
  EXPECT_NE(key_of({}), key_of({""}));
}

TEST(Key, order_matters) {
  EXPECT_NE(key_of({"a", "b"}), key_of({"b", "a"}));
}

TEST(Key, a_change_of_any_one_byte_changes_the_key) {
  const std::string text = "seventeen letters";  // two whole words of eight and one byte
  std::set<Key> keys{key_of({text})};
  for (size_t i = 0; i < text.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string changed = text;
      changed[i] = static_cast<char>(changed[i] ^ (1 << bit));
      EXPECT_TRUE(keys.insert(key_of({changed})).second) << "byte " << i << " bit " << bit;
    }
  }
}

TEST(Key, zero_bytes_of_every_length_differ) {
  std::set<Key> keys;
  for (size_t size = 0; size < 100; ++size) keys.insert(key_of({std::string(size, '\0')}));
  EXPECT_EQ(keys.size(), 100U);
}

TEST(Key, both_halves_depend_on_the_input) {
  EXPECT_NE(key_of({"a"}).high, key_of({"b"}).high);
  EXPECT_NE(key_of({"a"}).low, key_of({"b"}).low);
}

TEST(Key, folding_a_key_is_folding_its_text) {
  const Key inner = key_of({"inner"});
  EXPECT_EQ(KeyBuilder().add(inner).key(), KeyBuilder().add(inner.text()).key());
}

TEST(Key, bytes_and_text_of_the_same_content_agree) {
  const std::vector<uint8_t> bytes{'a', 'b', 'c'};
  EXPECT_EQ(KeyBuilder().add_bytes(bytes).key(), key_of({"abc"}));
}

TEST(Key, text_is_32_digits_with_leading_zeros) {
  EXPECT_EQ((Key{0, 0xab}.text()), "000000000000000000000000000000ab");
  EXPECT_EQ((Key{0x0123456789abcdef, 1}.text()), "0123456789abcdef0000000000000001");
}

/// Keys outlive the program in journals: this one may change only with a reason.
TEST(Key, is_stable_between_builds) {
  EXPECT_EQ(KeyBuilder().key().text(), "6c62272e07bb014262b821756295c58d");
  EXPECT_EQ(key_of({"inkbench", "a longer part of 31 characters"}).text(),
            "6e6b395d46d1957d0ee6d8be7218017d");
}

}  // namespace
}  // namespace inkbench
