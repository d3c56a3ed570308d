// SPDX-License-Identifier: MIT
#include "studies/sweep/kept_picture.h"

#include <gtest/gtest.h>

namespace inkbench {
namespace {

KeptPicture sample() {
  Picture picture(60, 40, 3);
  for (size_t i = 0; i < picture.samples.size(); ++i) picture.samples[i] = static_cast<uint8_t>(i * i >> 4);
  KeptPicture kept{make_tile(picture, {188, 40, 50, 11, 64, 128}), {}};
  kept.thumbnails = {{240, std::string("RIFF\0webp", 9)}, {180, ""}};
  return kept;
}

TEST(KeptPicture, reads_back_from_its_bytes) {
  EXPECT_GT(sample().tile.left.width_px, 0);
  EXPECT_EQ(kept_picture(bytes_of(sample())), sample());
  EXPECT_EQ(kept_picture(bytes_of(KeptPicture{})), KeptPicture{});
}

TEST(KeptPicture, any_damaged_byte_is_noticed) {
  const std::string bytes = bytes_of(sample());
  for (size_t i = 0; i < bytes.size(); i += 7) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    EXPECT_FALSE(kept_picture(damaged)) << i;
  }
}

TEST(KeptPicture, cut_off_anywhere_it_is_nothing) {
  const std::string bytes = bytes_of(sample());
  for (size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(kept_picture(bytes.substr(0, size))) << size;
}

}  // namespace
}  // namespace inkbench
