// SPDX-License-Identifier: MIT
// Buffers by name.
#include "pipeline/buffers.h"

#include <gmock/gmock.h>

#include <set>

#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;

TEST(BufferNames, every_buffer_is_found_by_its_own_name) {
  std::set<std::string_view> names;
  for (const BufferName buffer : all_buffers()) {
    EXPECT_THAT(parse_buffers({std::string(name_of(buffer))}, "here"), ElementsAre(buffer));
    names.insert(name_of(buffer));
  }
  EXPECT_EQ(names.size(), all_buffers().size());
}

TEST(BufferNames, the_table_has_them_by_their_number_keys) {
  EXPECT_TRUE(buffer_list().starts_with(
      "normal, depth, normal_edges, depth_edges, combined_edges, shaded, final, blinn_phong, object_id, "
      "reference, "))
      << buffer_list();
  std::string keys;
  for (const BufferName buffer : all_buffers()) {
    if (buffer.info().number_key >= 0) keys += std::to_string(buffer.info().number_key);
  }
  EXPECT_EQ(keys, "1234567890");
}

TEST(BufferNames, the_order_given_is_kept_and_each_comes_once) {
  EXPECT_THAT(parse_buffers({"final", " depth ", "final"}, "here"),
              ElementsAre(BufferName::final, BufferName::depth));
}

TEST(BufferNames, all_means_each_once) {
  EXPECT_EQ(parse_buffers({"all"}, "here").size(), all_buffers().size());
  const std::vector<BufferName> final_first = parse_buffers({"final", "all"}, "here");
  EXPECT_EQ(final_first.size(), all_buffers().size());
  EXPECT_EQ(final_first.front(), BufferName::final);
}

TEST(BufferNames, an_unknown_one_is_an_error_with_the_nearest) {
  EXPECT_EQ(error_of([] {
              parse_buffers({"final", "dept"}, "a.toml:3");
            }),
            "a.toml:3: unknown buffer 'dept'; did you mean 'depth'?");
}

TEST(BufferNames, naming_none_is_an_error) {
  EXPECT_EQ(error_of([] { parse_buffers({}, "a.toml:3"); }),
            "a.toml:3: names no buffer; for example: final, combined_edges");
}

}  // namespace
}  // namespace inkbench
