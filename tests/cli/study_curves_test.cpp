// SPDX-License-Identifier: MIT
// `pr = true`: precision and recall over thresholds in a study.
#include "tests/cli/study_fixture.h"

namespace inkbench {
namespace {

using testing::HasSubstr;
using testing::Not;

class StudyCurves : public StudyTest {
 protected:
  /// A curve for each detector, in two views.
  void write_two_detectors(const std::string& name, const std::string& more = "") const {
    write_spec(name, "measure = [\"f1\"]\npr = true\n" + more +
                         "[[axis]]\nkey = \"mesh.faces\"\nvalues = [0]\n"
                         "[[axis]]\nkey = \"edges.method\"\nvalues = [\"laplacian\", \"dihedral\"]\n"
                         "[[view]]\nname = \"front\"\n"
                         "[[view]]\nname = \"wide\"\n[view.set]\ncamera.fov = 70\n");
  }
};

TEST_F(StudyCurves, each_cell_has_its_numbers_and_each_detector_a_curve) {
  write_two_detectors("s");
  const CommandResult result = study("s", "out");
  ASSERT_TRUE(succeeds(result));
  EXPECT_THAT(result.out, HasSubstr("out/charts/precision_recall.png\n"));
  for (const auto& row : table("out").rows) {
    for (const char* key : {"ods", "ois", "ap"}) EXPECT_NE(row.at(key), "") << key;
  }
  const std::string svg = content_of(file("out/charts/precision_recall.svg"));
  for (const char* label : {"laplacian", "dihedral"}) EXPECT_THAT(svg, HasSubstr(label));
  EXPECT_THAT(content_of(file("out/index.html")), HasSubstr("charts/precision_recall.svg"));
  EXPECT_TRUE(succeeds(inkbench({"study", "verify", "out"})));
}

TEST_F(StudyCurves, a_curve_that_was_changed_is_counted_again_and_comes_out_the_same) {
  write_two_detectors("s");
  ASSERT_TRUE(succeeds(study("s", "out")));
  const FolderContent first = lasting_content(file("out"));
  write("out/curves/0002.csv", "changed");
  const CommandResult again = study("s", "out");
  ASSERT_TRUE(succeeds(again));
  EXPECT_THAT(again.err, HasSubstr("1 cell is measured again"));
  EXPECT_EQ(difference(lasting_content(file("out")), first), "same");
}

TEST_F(StudyCurves, are_not_drawn_unasked) {
  write_spec("s", "measure = true\n" + threshold_axis(2));
  ASSERT_TRUE(succeeds(study("s", "out")));
  EXPECT_FALSE(fs::exists(file("out/curves")));
  EXPECT_THAT(table("out").columns, Not(testing::Contains("ods")));
}

TEST_F(StudyCurves, pr_is_true_or_false) {
  write_spec("s", "pr = \"yes\"\n");
  EXPECT_TRUE(is_input_error(study("s", "out"), {"s.toml", "pr is", "it must be true or false"}));
}

}  // namespace
}  // namespace inkbench
