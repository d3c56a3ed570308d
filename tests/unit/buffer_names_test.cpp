// Buffers by name.
#include "pipeline/flow/buffer_names.h"

#include <gmock/gmock.h>

#include <set>

#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;

TEST(BufferNames, every_buffer_is_found_by_its_own_name) {
  for (size_t i = 0; i < kBufferNames.size(); ++i) {
    const auto buffer = static_cast<BufferName>(i);
    EXPECT_THAT(parse_buffers({std::string(name_of(buffer))}, "here"), ElementsAre(buffer));
  }
  EXPECT_EQ(std::set<std::string_view>(kBufferNames.begin(), kBufferNames.end()).size(), kBufferNames.size());
}

TEST(BufferNames, the_enum_and_the_names_agree) {
  EXPECT_EQ(name_of(BufferName::normal), "normal");
  EXPECT_EQ(name_of(BufferName::depth), "depth");
  EXPECT_EQ(name_of(BufferName::normal_edges), "normal_edges");
  EXPECT_EQ(name_of(BufferName::depth_edges), "depth_edges");
  EXPECT_EQ(name_of(BufferName::combined_edges), "combined_edges");
  EXPECT_EQ(name_of(BufferName::shaded), "shaded");
  EXPECT_EQ(name_of(BufferName::final), "final");
  EXPECT_EQ(name_of(BufferName::blinn_phong), "blinn_phong");
  EXPECT_EQ(name_of(BufferName::object_id), "object_id");
}

TEST(BufferNames, the_order_given_is_kept_and_each_comes_once) {
  EXPECT_THAT(parse_buffers({"final", " depth ", "final"}, "here"),
              ElementsAre(BufferName::final, BufferName::depth));
}

TEST(BufferNames, all_means_each_once) {
  EXPECT_EQ(parse_buffers({"all"}, "here").size(), kBufferNames.size());
  const std::vector<BufferName> final_first = parse_buffers({"final", "all"}, "here");
  EXPECT_EQ(final_first.size(), kBufferNames.size());
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
