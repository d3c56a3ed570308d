// SPDX-License-Identifier: MIT
// BSDS500's ground truth: MATLAB files.
#include "pipeline/image/bsds_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/scratch_folder.h"
#include "tests/unit/mat_bytes.h"

namespace inkbench {
namespace {

using testing::HasSubstr;

class BsdsFile : public testing::Test {
 protected:
  std::vector<Picture> read(const std::string& content) const {
    write_file_atomically(path_, content);
    return read_bsds_boundaries(path_);
  }
  std::string error_of(const std::string& content) const {
    try {
      read(content);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

 private:
  ScratchFolder folder_;
  fs::path path_ = folder_.path() / "100007.mat";
};

std::string two_annotators() {
  return mat_ground_truth({mat_annotator({"#..", ".#."}), mat_annotator({"..#", "..."})});
}

void expect_two_annotators(const std::vector<Picture>& pictures) {
  ASSERT_EQ(pictures.size(), 2U);
  EXPECT_EQ(pictures[0].width_px, 3);
  EXPECT_EQ(pictures[0].height_px, 2);
  EXPECT_EQ(pictures[0].samples, (std::vector<uint8_t>{255, 0, 0, 0, 255, 0}));
  EXPECT_EQ(pictures[1].samples, (std::vector<uint8_t>{0, 0, 255, 0, 0, 0}));
}

TEST_F(BsdsFile, every_annotators_boundaries_are_read) {
  expect_two_annotators(read(mat_file(two_annotators())));
}

TEST_F(BsdsFile, compressed_elements_are_unpacked) {
  expect_two_annotators(read(mat_file(mat_compressed(two_annotators()))));
}

TEST_F(BsdsFile, a_file_cut_off_anywhere_is_refused) {
  for (const std::string& whole : {mat_file(two_annotators()), mat_file(mat_compressed(two_annotators()))}) {
    // The last bytes pad the last element.
    for (size_t bytes = 0; bytes + 8 < whole.size(); ++bytes)
      ASSERT_NE(error_of(whole.substr(0, bytes)), "") << bytes << " of " << whole.size();
  }
}

TEST_F(BsdsFile, what_is_another_file_is_said) {
  EXPECT_THAT(error_of(mat_file(mat_matrix(mat_head(9, {1, 1}, "x") + mat_element(2, "1")))),
              HasSubstr("holds no `groundTruth` with `Boundaries`"));
  EXPECT_THAT(error_of("MATLAB 7.3 MAT-file" + std::string(200, ' ')),
              HasSubstr("version 7.3, which is not read"));
  EXPECT_THAT(error_of("\x89PNG and so on"), HasSubstr("is no MATLAB file"));
}

TEST_F(BsdsFile, annotators_of_other_sizes_are_refused) {
  EXPECT_THAT(error_of(mat_file(mat_ground_truth({mat_annotator({"#.."}), mat_annotator({"#."})}))),
              HasSubstr("has drawings of different sizes"));
}

TEST_F(BsdsFile, sides_that_the_numbers_do_not_fill_are_refused) {
  const std::string lying = mat_matrix(mat_head(9, {60000, 60000}, "") + mat_element(2, "12345678"));
  constexpr size_t kNameBytes = 16;
  std::string name = "Boundaries";
  name.resize(kNameBytes, '\0');
  const std::string annotator = mat_matrix(mat_head(2, {1, 1}, "") + mat_number(5 | 4 << 16) +
                                           mat_number(kNameBytes) + mat_element(1, name) + lying);
  EXPECT_THAT(error_of(mat_file(mat_ground_truth({annotator}))), HasSubstr("is damaged or cut off"));
}

}  // namespace
}  // namespace inkbench
