// SPDX-License-Identifier: MIT
// A search with marks alone, on a small scene, draws what was asked, finds no reference lines, and says what
// it could not do.
#include <algorithm>

#include "pipeline/lines/drawing.h"
#include "pipeline/pipeline.h"
#include "studies/tuning/mark_report.h"
#include "studies/tuning/trial_meter.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

using ::testing::Test;

LineMap minus_near(const LineMap& lines, const LineMap& others, int reach_px) {
  LineMap result(lines.width_px(), lines.height_px());
  for_each_pixel(lines, [&](int x, int y) {
    for (int dy = -reach_px; dy <= reach_px; ++dy) {
      for (int dx = -reach_px; dx <= reach_px; ++dx) {
        if (others.contains(x + dx, y + dy) && others.at(x + dx, y + dy)) return;
      }
    }
    result.set(x, y);
  });
  return result;
}

class MarksSearch : public Test {
 protected:
  MarksSearch() {
    spec_.base = analytic_scene();
    spec_.space = {default_axis(spec_.base, "combine.k_depth", ""),
                   default_axis(spec_.base, "combine.k_normal", "")};
    spec_.objective = marks_objective(false);
    spec_.groups = {"all"};
    spec_.budget = 120;
    spec_.pictures.resize(1);
  }

  Settings asked() const {
    Settings settings = spec_.base;
    settings.combine.k_depth = 0.05F;
    settings.combine.k_normal = 0.2F;
    return settings;
  }
  LineMap drawn(const Settings& settings) {
    return line_map_from(pipeline_.at(settings).raw(BufferName::lines));
  }
  TuneResult search() {
    TrialMeter meter(pipeline_, spec_);
    return tune(problem_of(spec_),
                [&](const std::vector<Values>& candidates, const std::vector<bool>& wanted) {
                  return meter.measure(candidates, wanted);
                });
  }
  Settings tuned(const TuneResult& result) const {
    return with_values(spec_.base, spec_.space, result.tuned().values);
  }

  Pipeline pipeline_;
  TuneSpec spec_;
};

TEST_F(MarksSearch, with_unwanted_marks_over_all_that_other_values_leave_out_finds_such_values) {
  spec_.base = paper_scene(160, 120);
  const LineMap now = drawn(spec_.base), aim = drawn(asked());
  const LineMap too_much = minus_near(now, aim, 2);
  ASSERT_GT(too_much.count(), 50) << "the values that are asked for draw less";
  spec_.pictures[0].marks = MarkFile{{aim, too_much, now}, true};
  const TuneResult result = search();
  EXPECT_LT(result.initial().score.value, 0.1);
  EXPECT_GT(result.tuned().score.value, 0.95);
  const LineMap after = drawn(tuned(result));
  EXPECT_LT(after.count(), now.count() - too_much.count() / 2);
  EXPECT_EQ(pipeline_.counts().at("reference").runs, 0) << "no reference lines are asked for";
}

TEST_F(MarksSearch, without_a_kept_drawing_judges_by_what_the_scene_draws) {
  const LineMap now = drawn(spec_.base);
  const LineMap none(now.width_px(), now.height_px());
  spec_.pictures[0].marks = MarkFile{{none, now, none}, false};
  PictureMarks marks(pipeline_, spec_);
  ASSERT_NE(marks.find(0), nullptr);
  EXPECT_EQ(marks.find(0)->marks.drawn, now);
}

TEST_F(MarksSearch, names_the_stroke_that_nothing_drew_and_no_method_that_does_not_help) {
  const LineMap now = drawn(spec_.base);
  LineMap corner(now.width_px(), now.height_px());
  for (int x = 10; x < 40; ++x) corner.set(x, 6);  // of the background
  spec_.pictures[0].name = spec_.pictures[0].of_view = "front";
  spec_.pictures[0].marks = MarkFile{{corner, LineMap(now.width_px(), now.height_px()), now}, true};
  spec_.budget = kLeastBudget;
  const MarkReport report = look_at_marks(pipeline_, spec_, search());
  ASSERT_FALSE(report.methods.empty());
  const std::vector<std::string> sentences = mark_sentences(report);
  ASSERT_EQ(sentences.size(), 2);
  EXPECT_EQ(sentences[0], "front: 1 of 1 wanted stroke is missed, at (24, 6).");
  EXPECT_EQ(sentences[1], "No other method, with the scene's own values, satisfies more strokes.");
}

TEST_F(MarksSearch, names_the_method_that_draws_what_is_wanted) {
  Settings other = spec_.base;
  find_param(other, "edges.method", "").set(std::string("dihedral"), "");
  const LineMap aim = drawn(other);
  ASSERT_GT(aim.count(), 50);
  const LineMap none(aim.width_px(), aim.height_px());
  spec_.base.combine.use_depth = spec_.base.combine.use_normal = false;  // the paper's method draws nothing
  spec_.pictures[0].marks = MarkFile{{aim, none, none}, true};
  spec_.budget = kLeastBudget;
  const MarkReport report = look_at_marks(pipeline_, spec_, search());
  EXPECT_EQ(report.tuned.satisfied(), 0);
  const std::vector<const Compliance*> better = report.better();
  EXPECT_TRUE(std::any_of(better.begin(), better.end(), [](const Compliance* method) {
    return method->name == "dihedral" && method->satisfied() == method->strokes();
  }));
}

}  // namespace
}  // namespace inkbench
