// SPDX-License-Identifier: MIT
// Marks as files, and as a search's spec names them.
#include "pipeline/image/image_file.h"
#include "studies/tuning/mark_file.h"
#include "studies/tuning/trial_journal.h"
#include "studies/tuning/tune_spec.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr int kMarkedWide = 32, kMarkedHigh = 20;

LineMap row_of_marks(int y) {
  LineMap map(kMarkedWide, kMarkedHigh);
  for (int x = 4; x < 28; ++x) map.set(x, y);
  return map;
}

/// A picture of one colour with a row of another.
Picture with_row(std::array<uint8_t, 4> ground, std::array<uint8_t, 4> colour, int y) {
  Picture picture(kMarkedWide, kMarkedHigh, 4);
  for (int row = 0; row < kMarkedHigh; ++row) {
    for (int x = 0; x < kMarkedWide; ++x) {
      for (int c = 0; c < 4; ++c)
        picture.at(x, row, c) = row == y && x >= 4 && x < 28 ? colour[c] : ground[c];
    }
  }
  return picture;
}

class TuneMarks : public ::testing::Test {
 protected:
  /// A spec of that many views with this on top.
  TuneSpec spec(const std::string& rest, int views = 2) const {
    std::string text = "size = [32, 20]\n";
    text += rest + "\n[[search]]\nkey = \"combine.k_depth\"\n";
    for (const char* name : {"front", "side"}) {
      if (views-- > 0) text += "[[view]]\nname = \"" + std::string(name) + "\"\nset = {}\n";
    }
    return parse_tune_spec(text, folder_.path() / "spec.toml");
  }
  std::string error(const std::string& rest, int views = 2) const {
    return error_of([&] { spec(rest, views); });
  }
  void marks_file(const std::string& name) const {
    write_marks(folder_.path() / name, {row_of_marks(5), row_of_marks(12), row_of_marks(12)});
  }

  TemporaryFolder folder_;
};

TEST_F(TuneMarks, come_back_from_a_file_with_what_was_drawn_under_them) {
  LineMap drawn = row_of_marks(12);
  drawn.set(10, 5);
  write_marks(folder_.path() / "m.png", {row_of_marks(5), row_of_marks(12), drawn});
  const MarkFile file = read_marks(folder_.path() / "m.png", kMarkedWide, kMarkedHigh);
  EXPECT_TRUE(file.keeps_drawing);
  EXPECT_EQ(file.marks.wanted, row_of_marks(5));
  EXPECT_EQ(file.marks.unwanted, row_of_marks(12));
  EXPECT_EQ(file.marks.drawn, drawn);
}

TEST_F(TuneMarks, painted_by_hand_on_any_ground_keep_no_drawing) {
  for (const std::array<uint8_t, 4>& ground :
       {std::array<uint8_t, 4>{255, 255, 255, 255}, {0, 0, 0, 255}, {0, 0, 0, 0}, {120, 90, 70, 255}}) {
    write_png(folder_.path() / "m.png", with_row(ground, {0, 0, 255, 255}, 7), {});
    const MarkFile file = read_marks(folder_.path() / "m.png", kMarkedWide, kMarkedHigh);
    EXPECT_FALSE(file.keeps_drawing);
    EXPECT_EQ(file.marks.unwanted, row_of_marks(7));
    EXPECT_EQ(file.marks.wanted.count(), 0);
  }
}

TEST_F(TuneMarks, of_another_size_than_their_view_are_refused_by_name) {
  marks_file("small.png");
  const std::string error = error_of([&] { read_marks(folder_.path() / "small.png", 64, 40); });
  EXPECT_THAT(error, AllOf(HasSubstr("small.png"), HasSubstr("32 x 20"), HasSubstr("64 x 40")));
}

TEST_F(TuneMarks, a_file_without_any_is_refused) {
  write_png(folder_.path() / "m.png", with_row({255, 255, 255, 255}, {0, 0, 0, 255}, 7), {});
  EXPECT_THAT(error_of([&] { read_marks(folder_.path() / "m.png", kMarkedWide, kMarkedHigh); }),
              HasSubstr("no pixel is red or blue"));
}

TEST_F(TuneMarks, are_looked_at_with_a_little_f_unless_reference_lines_are_not_wanted) {
  marks_file("m.png");
  const std::string marks = "[[marks]]\nview = \"front\"\nfile = \"m.png\"\n";
  EXPECT_EQ(spec(marks).objective.text(), "marks + 0.05 f1");
  EXPECT_EQ(spec(marks + "[objective]\nreference = false\n", 1).objective.text(), "marks");
  EXPECT_EQ(spec("").objective.text(), "f1");
}

TEST_F(TuneMarks, belong_to_the_picture_that_they_name) {
  marks_file("m.png");
  const TuneSpec two = spec("[[marks]]\nview = \"side\"\nfile = \"m.png\"\n");
  EXPECT_FALSE(two.pictures[0].marks);
  ASSERT_TRUE(two.pictures[1].marks);
  EXPECT_EQ(two.pictures[1].marks->marks.wanted, row_of_marks(5));
  EXPECT_TRUE(spec("[[marks]]\nfile = \"m.png\"\n", 0).pictures[0].marks);
}

TEST_F(TuneMarks, are_not_left_out_in_turn_unless_the_spec_says_so) {
  marks_file("m.png");
  const std::string marks = "[[marks]]\nview = \"front\"\nfile = \"m.png\"\n";
  EXPECT_EQ(spec(marks).groups.size(), 1);
  EXPECT_EQ(spec("leave_out = \"view\"\n" + marks).groups.size(), 2);
}

TEST_F(TuneMarks, that_name_no_picture_are_refused) {
  marks_file("m.png");
  EXPECT_THAT(error("[[marks]]\nview = \"frond\"\nfile = \"m.png\"\n"),
              AllOf(HasSubstr("spec.toml:3"), HasSubstr("did you mean 'front'?")));
  EXPECT_THAT(error("[[marks]]\nfile = \"m.png\"\n"), HasSubstr("one of: front, side"));
  EXPECT_THAT(error("[[marks]]\nview = \"front\"\n"), HasSubstr("without a file"));
  const std::string marks = "[[marks]]\nview = \"front\"\nfile = \"m.png\"\n";
  EXPECT_THAT(error(marks + marks), HasSubstr("second marks"));
}

TEST_F(TuneMarks, and_objectives_that_do_not_fit_each_other_are_refused) {
  marks_file("m.png");
  const std::string marks = "[[marks]]\nview = \"front\"\nfile = \"m.png\"\n";
  EXPECT_THAT(error("[objective]\nmarks = 1\n"), HasSubstr("there are none"));
  EXPECT_THAT(error(marks + "[objective]\nf1 = 1\n"), HasSubstr("looks at none of them"));
  EXPECT_THAT(error(marks + "[objective]\nmarks = 1\n"), HasSubstr("side has no marks"));
  EXPECT_THAT(error(marks + "[objective]\nreference = false\nmarks = 1\nrecall = 1\n"),
              HasSubstr("recall needs reference lines"));
}

TEST_F(TuneMarks, are_kept_by_the_journal) {
  DrawingTally tally;
  tally.marks = MarkTally{{3, 7}, {1, 9}};
  const std::optional<DrawingTally> again = tally_from(tally_text(tally));
  ASSERT_TRUE(again && again->marks);
  EXPECT_EQ(find_measure("marks")->value(*again), find_measure("marks")->value(tally));
  EXPECT_FALSE(tally_from(tally_text({}))->marks);
}

}  // namespace
}  // namespace inkbench
