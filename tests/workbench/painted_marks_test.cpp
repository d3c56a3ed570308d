// SPDX-License-Identifier: MIT
// Painted marks as a value: strokes, the text that the session keeps, steps of undo, files for a search.
#include "app/workbench/painted_marks.h"

#include "app/workbench/document.h"
#include "app/workbench/session.h"
#include "studies/tuning/tune_spec.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr int kPaintedWide = 24, kPaintedHigh = 16;

MarkMaps unpainted() {
  const LineMap none(kPaintedWide, kPaintedHigh);
  return {none, none, none};
}

LineMap all_lines() {
  LineMap map(kPaintedWide, kPaintedHigh);
  for (int y = 0; y < kPaintedHigh; ++y) {
    for (int x = 0; x < kPaintedWide; ++x) map.set(x, y);
  }
  return map;
}

BrushStroke across(MarkBrush brush, double y, double radius = 2) {
  return {brush, radius, {{4.5, y}, {19.5, y}}};
}

MarkMaps painted(const std::vector<BrushStroke>& strokes, const LineMap& drawn) {
  MarkMaps maps = unpainted();
  for (const BrushStroke& stroke : strokes) paint(maps, stroke, drawn);
  return maps;
}

TEST(PaintedMarks, a_stroke_covers_the_pixels_whose_centres_the_brush_goes_over) {
  const LineMap map = pixels_of(across(MarkBrush::wanted, 8.5), kPaintedWide, kPaintedHigh);
  EXPECT_TRUE(map.at(12, 6) && map.at(12, 10) && !map.at(12, 5) && !map.at(12, 11));
  EXPECT_TRUE(map.at(2, 8) && !map.at(1, 8) && !map.at(2, 6)) << "its ends are round";
  const BrushStroke click{MarkBrush::wanted, 0.1, {{3.1, 3.9}}};
  EXPECT_THAT(pixels_of(pixels_of(click, kPaintedWide, kPaintedHigh)), ElementsAre(Pixel{3, 3}));
}

TEST(PaintedMarks, strokes_outside_the_picture_are_cut_off) {
  const BrushStroke stroke{MarkBrush::wanted, 3, {{-20, -20}, {-5, 8}, {1000, 8}}};
  EXPECT_TRUE(pixels_of(stroke, kPaintedWide, kPaintedHigh).at(23, 8));
}

TEST(PaintedMarks, the_last_brush_counts_and_the_eraser_leaves_nothing) {
  const BrushStroke wanted = across(MarkBrush::wanted, 8), unwanted = across(MarkBrush::unwanted, 8, 1);
  const MarkMaps both = painted({wanted, unwanted}, all_lines());
  EXPECT_TRUE(both.unwanted.at(12, 8) && !both.wanted.at(12, 8) && both.wanted.at(12, 9));
  EXPECT_TRUE(painted({wanted, unwanted, across(MarkBrush::eraser, 8, 4)}, all_lines()).empty());
}

TEST(PaintedMarks, keep_what_was_drawn_under_them_when_they_were_painted) {
  LineMap row(kPaintedWide, kPaintedHigh);
  for (int x = 0; x < kPaintedWide; ++x) row.set(x, 8);
  MarkMaps maps = painted({across(MarkBrush::unwanted, 8.5)}, row);
  EXPECT_EQ(maps.drawn.count(), 20) << "columns 2 to 21 of the row";
  paint(maps, across(MarkBrush::unwanted, 3.5, 1), all_lines());
  EXPECT_TRUE(maps.drawn.at(12, 8) && maps.drawn.at(12, 3) && !maps.drawn.at(12, 9));
}

TEST(PaintedMarks, come_back_from_their_runs) {
  const MarkMaps maps = painted({across(MarkBrush::unwanted, 3), across(MarkBrush::wanted, 12)}, all_lines());
  const MarkMaps again = marks_from_runs(runs_of(maps), kPaintedWide, kPaintedHigh, "");
  EXPECT_EQ(again.wanted, maps.wanted);
  EXPECT_EQ(again.unwanted, maps.unwanted);
  EXPECT_EQ(again.drawn, maps.drawn);
}

TEST(PaintedMarks, damaged_runs_are_refused) {
  for (const char* runs : {"", "383.", "385.", "384.w", "384x", "384", "99999999999999999999."})
    EXPECT_THAT(error_of([&] { marks_from_runs(runs, kPaintedWide, kPaintedHigh, "s:3"); }),
                HasSubstr("s:3"));
}

TEST(PaintedMarks, belong_to_their_camera_and_size) {
  CameraParams front, side;
  side.eye = {5, 0, 0};
  const PaintedMarks marks = with_maps({}, front, painted({across(MarkBrush::wanted, 8)}, all_lines()));
  EXPECT_NE(find_marks(marks, front, kPaintedWide, kPaintedHigh), nullptr);
  EXPECT_EQ(find_marks(marks, side, kPaintedWide, kPaintedHigh), nullptr);
  EXPECT_EQ(find_marks(marks, front, kPaintedHigh, kPaintedWide), nullptr);
  EXPECT_TRUE(with_maps(marks, front, unpainted()).empty());
}

TEST(PaintedMarks, come_back_with_the_session) {
  Session session = first_session();
  session.marks =
      with_maps({}, session.settings.camera, painted({across(MarkBrush::unwanted, 8)}, all_lines()));
  const Session again = parse_session(session_text(session), "s");
  EXPECT_EQ(session_text(again), session_text(session));
  ASSERT_EQ(again.marks.size(), 1);
  EXPECT_EQ(again.marks[0].runs, session.marks[0].runs);
}

TEST(PaintedMarks, in_a_damaged_session_are_named_by_line) {
  const std::string text = "[session]\n[[session.marks]]\nwidth = 4\nheight = 2\nruns = \"7.\"\n";
  EXPECT_THAT(error_of([&] { parse_session(text, "s.toml"); }), HasSubstr("s.toml:2"));
}

TEST(PaintedMarks, a_stroke_is_a_step_that_undo_takes_back_and_leaves_settings_alone) {
  MessageLog log;
  Problems problems(log);
  Document document(paper_settings(), {}, problems);
  const PaintedMarks one = with_maps({}, {}, painted({across(MarkBrush::wanted, 8)}, all_lines()));
  document.set_marks(one, "mark as wanted");
  document.change("combine.k_depth", Value(0.01F));
  EXPECT_TRUE(same_marks(document.marks(), one)) << "they stay when settings change";
  document.undo();
  EXPECT_TRUE(same_marks(document.marks(), one));
  document.undo();
  EXPECT_TRUE(document.marks().empty());
  EXPECT_EQ(text(document.settings()), text(paper_settings()));
  document.redo();
  EXPECT_TRUE(same_marks(document.marks(), one));
  document.set_marks(one, "again");
  EXPECT_TRUE(document.history().can_redo()) << "equal marks are no step";
}

TEST(PaintedMarks, written_for_a_search_are_what_it_reads) {
  const TemporaryFolder folder;
  CameraParams front, side, bare;
  side.eye = {5, 0, 0};
  bare.eye = {0, 5, 1};
  const MarkMaps first = painted({across(MarkBrush::wanted, 8)}, all_lines());
  const MarkMaps second = painted({across(MarkBrush::unwanted, 4)}, all_lines());
  const PaintedMarks marks = with_maps(with_maps({}, front, first), side, second);
  const std::vector<MarkedView> views{{"front", front}, {"bare", bare}, {"side", side}};
  const std::string tables = write_mark_files(folder.path(), marks, views, kPaintedWide, kPaintedHigh);
  std::string spec = "size = [24, 16]\n[[search]]\nkey = \"combine.k_depth\"\n" + tables;
  for (const MarkedView& view : views) spec += "[[view]]\nname = \"" + view.name + "\"\nset = {}\n";
  const TuneSpec read = parse_tune_spec(spec, folder.path() / "spec.toml");
  ASSERT_TRUE(read.pictures[0].marks && read.pictures[2].marks);
  EXPECT_FALSE(read.pictures[1].marks);
  EXPECT_EQ(read.pictures[0].marks->marks.wanted, first.wanted);
  EXPECT_EQ(read.pictures[2].marks->marks.unwanted, second.unwanted);
  EXPECT_EQ(read.pictures[2].marks->marks.drawn, second.drawn);
  EXPECT_EQ(write_mark_files(folder.path(), {}, views, kPaintedWide, kPaintedHigh), "");
}

}  // namespace
}  // namespace inkbench
