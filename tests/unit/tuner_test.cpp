// SPDX-License-Identifier: MIT
// The search against objectives whose best values are known, by made-up counts instead of drawings.
#include "studies/tuning/tuner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "pipeline/base/files.h"
#include "pipeline/base/stop.h"
#include "studies/tuning/even_cover.h"
#include "studies/tuning/tune_spec.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::HasSubstr;

/// Lines with this F, exactly to a millionth: as many wanted as drawn.
DrawingTally tally_of(double f) {
  DrawingTally tally;
  tally.lines.predicted = tally.lines.referenced = 1'000'000;
  tally.lines.at_tolerance.matched = tally.lines.at_tolerance.allowed = std::llround(f * 1e6);
  return tally;
}

using FOfValues = std::function<double(const Values& values, size_t group)>;

/// Measures by a function, and counts how often.
struct Maker {
  FOfValues f;
  size_t groups = 1;
  size_t measured = 0;
  size_t stop_after = SIZE_MAX;

  MeasureCandidates measure() {
    return [this](const std::vector<Values>& candidates, const std::vector<bool>& wanted) {
      std::vector<GroupTallies> result;
      for (const Values& values : candidates) {
        if (++measured > stop_after) throw Stopped();
        GroupTallies tallies(groups);
        for (size_t g = 0; g < groups; ++g) {
          if (wanted[g]) tallies[g] = tally_of(f(values, g));
        }
        result.push_back(std::move(tallies));
      }
      return result;
    };
  }
};

double number(const Value& value) {
  return std::get<float>(value);
}

SearchAxis side(const std::string& key, double from, double to, Scale scale = Scale::linear) {
  SearchAxis axis;
  axis.key = key;
  axis.from = from;
  axis.to = to;
  axis.scale = scale;
  return axis;
}

/// Two coefficients between 0 and 1, from 0.9 and 0.9.
TuneProblem two_numbers(int budget = 300) {
  TuneProblem problem;
  problem.space = {side("combine.k_depth", 0.001, 1), side("combine.k_normal", 0.001, 1)};
  problem.objective = default_objective();
  problem.groups = {"all"};
  problem.start = {0.9F, 0.9F};
  problem.budget = budget;
  return problem;
}

double smooth_hill(const Values& values, double x, double y) {
  const double dx = number(values[0]) - x, dy = number(values[1]) - y;
  return 0.95 * std::exp(-4 * (dx * dx + dy * dy));
}

/// What a thousand by a thousand candidates, evenly spread, reach at best.
double brute_force(const FOfValues& f) {
  double best = 0;
  for (int i = 0; i <= 1000; ++i) {
    for (int k = 0; k <= 1000; ++k)
      best = std::max(
          best,
          f({0.001F + 0.000999F * static_cast<float>(i), 0.001F + 0.000999F * static_cast<float>(k)}, 0));
  }
  return best;
}

TEST(Tuner, finds_the_top_of_a_smooth_hill) {
  Maker maker{[](const Values& values, size_t) { return smooth_hill(values, 0.313, 0.721); }};
  const TuneResult result = tune(two_numbers(), maker.measure());
  EXPECT_NEAR(result.tuned().score.value, brute_force(maker.f), 1e-4);
  EXPECT_NEAR(number(result.tuned().values[0]), 0.313, 0.01);
  EXPECT_NEAR(number(result.tuned().values[1]), 0.721, 0.01);
}

TEST(Tuner, finds_the_top_of_stairs) {
  Maker maker{
      [](const Values& values, size_t) { return std::floor(40 * smooth_hill(values, 0.62, 0.17)) / 40; }};
  const TuneResult result = tune(two_numbers(), maker.measure());
  EXPECT_DOUBLE_EQ(result.tuned().score.value, std::llround(1e6 * brute_force(maker.f)) / 1e6);
}

TEST(Tuner, never_ends_worse_than_the_default_or_the_papers_values) {
  const auto spike_at = [](float at) {
    return [at](const Values& values, size_t) {
      return number(values[0]) == at && number(values[1]) == at ? 0.9 : 0.1;
    };
  };
  TuneProblem problem = two_numbers(60);
  problem.others = {{0.3333F, 0.3333F}};
  Maker at_start{spike_at(0.9F)}, at_paper{spike_at(0.3333F)};
  EXPECT_DOUBLE_EQ(tune(problem, at_start.measure()).tuned().score.value, 0.9);
  EXPECT_DOUBLE_EQ(tune(problem, at_paper.measure()).tuned().score.value, 0.9);
}

TEST(Tuner, looks_at_no_more_candidates_than_the_budget_says) {
  for (const int budget : {10, 11, 37, 100, 301}) {
    TuneProblem problem = two_numbers(budget);
    problem.groups = {"a", "b", "c"};
    problem.others = {{0.5F, 0.5F}};
    Maker maker{[](const Values& values, size_t g) {
                  return smooth_hill(values, 0.2 + 0.1 * static_cast<double>(g), 0.4);
                },
                3};
    const TuneResult result = tune(problem, maker.measure());
    EXPECT_LE(maker.measured, static_cast<size_t>(budget));
    EXPECT_EQ(maker.measured, result.trials.size());
    EXPECT_EQ(result.left_out.size(), 3U);
  }
}

TEST(Tuner, same_seed_same_way) {
  const FOfValues f = [](const Values& values, size_t) { return smooth_hill(values, 0.3, 0.7); };
  TuneProblem problem = two_numbers(120);
  problem.space.push_back(side("combine.threshold", 0, 2));
  problem.start.emplace_back(1.0F);
  Maker first{f}, again{f}, other{f};
  const TuneResult a = tune(problem, first.measure()), b = tune(problem, again.measure());
  problem.seed = 2;
  const TuneResult c = tune(problem, other.measure());
  ASSERT_EQ(a.trials.size(), b.trials.size());
  for (size_t i = 0; i < a.trials.size(); ++i) EXPECT_EQ(a.trials[i].values, b.trials[i].values) << i;
  EXPECT_NE(a.trials[1].values, c.trials[1].values);
}

TEST(Tuner, leave_one_out_judges_what_it_was_not_tuned_on) {
  // Each group has its own best place: what is good for the others is poor for the one left out.
  const std::vector<double> places{0.1, 0.5, 0.9};
  TuneProblem problem = two_numbers(400);
  problem.start = {0.5F, 0.5F};
  problem.groups = {"a", "b", "c"};
  Maker maker{[&](const Values& values, size_t g) { return smooth_hill(values, places[g], places[g]); }, 3};
  const TuneResult result = tune(problem, maker.measure());
  ASSERT_EQ(result.left_out.size(), 3U);
  EXPECT_NEAR(number(result.left_out[0].values[0]), 0.7, 0.05) << "between the others' places";
  EXPECT_NEAR(result.left_out[0].tuned.value, smooth_hill(result.left_out[0].values, 0.1, 0.1), 1e-6);
  ASSERT_TRUE(result.is_gain());
  EXPECT_FALSE(*result.is_gain()) << "the default is the best for all of them";
}

TEST(Tuner, what_has_no_influence_does_not_matter) {
  Maker maker{[](const Values& values, size_t) { return smooth_hill({values[0], 0.5F}, 0.3, 0.5); }};
  const TuneResult result = tune(two_numbers(), maker.measure());
  ASSERT_EQ(result.axes.size(), 2U);
  EXPECT_TRUE(result.axes[0].matters());
  EXPECT_FALSE(result.axes[1].matters());
  ASSERT_TRUE(result.axes[1].equally_good);
  EXPECT_NEAR(result.axes[1].equally_good->first, 0.001, 1e-9);
  EXPECT_NEAR(result.axes[1].equally_good->second, 1, 1e-9);
}

TEST(Tuner, the_plateau_is_the_share_of_the_box_that_is_as_good) {
  Maker maker{[](const Values& values, size_t) { return number(values[0]) < 0.5 ? 0.8 : 0.2; }};
  EXPECT_NEAR(tune(two_numbers(600), maker.measure()).plateau, 0.5, 0.05);
}

TEST(Tuner, choices_are_tried_and_the_sides_without_effect_left_alone) {
  TuneProblem problem = two_numbers(200);
  SearchAxis method;
  method.key = "edges.method";
  method.choices = {std::string("paper"), std::string("dihedral"), std::string("laplacian")};
  problem.space = {method, side("dihedral.angle", 5, 90), side("laplacian.bend", 0.05, 5, Scale::log)};
  problem.start = {std::string("paper"), 40.0F, 1.0F};
  Maker maker{[](const Values& values, size_t) {
    if (std::get<std::string>(values[0]) != "dihedral") return 0.3;
    return 0.95 - 0.01 * std::abs(number(values[1]) - 33);
  }};
  const TuneResult result = tune(problem, maker.measure());
  EXPECT_EQ(std::get<std::string>(result.tuned().values[0]), "dihedral");
  EXPECT_NEAR(number(result.tuned().values[1]), 33, 1);
  EXPECT_FALSE(result.axes[2].has_effect) << "nothing of the Laplacian matters to another method";
}

TEST(Tuner, limits_come_before_the_objective) {
  TuneProblem problem = two_numbers();
  problem.objective.constraints = {parse_constraint("ink <= 0.25", "test")};
  const MeasureCandidates measure = [](const std::vector<Values>& candidates, const std::vector<bool>&) {
    std::vector<GroupTallies> result;
    for (const Values& values : candidates) {
      DrawingTally tally = tally_of(number(values[0]));
      tally.pixels = 1000;
      tally.ink = std::llround(1000 * number(values[0]));
      result.push_back({tally});
    }
    return result;
  };
  const TuneResult result = tune(problem, measure);
  EXPECT_TRUE(result.tuned().score.keeps_limits());
  EXPECT_NEAR(result.tuned().score.value, 0.25, 0.01);
}

TEST(Tuner, stopped_it_gives_the_best_so_far) {
  Maker maker{[](const Values& values, size_t) { return smooth_hill(values, 0.3, 0.7); }};
  maker.stop_after = 100;
  const TuneResult result = tune(two_numbers(), maker.measure());
  EXPECT_TRUE(result.stopped);
  EXPECT_GE(result.tuned().score.value, result.initial().score.value);
  EXPECT_LE(result.trials.size(), 100U);
}

TEST(EvenCover, two_numbers_are_a_grid_to_the_ends) {
  const SearchSpace space{side("combine.k_depth", 1, 2), side("combine.k_normal", 1, 2)};
  const std::vector<Point> points = even_cover(space, 30, 1);
  ASSERT_EQ(points.size(), 25U);
  EXPECT_EQ(points.front(), (Point{0, 0}));
  EXPECT_EQ(points.back(), (Point{1, 1}));
}

TEST(EvenCover, more_numbers_fill_every_eighth_of_each_side_evenly) {
  const SearchSpace space(4, side("combine.k_depth", 1, 2));
  const std::vector<Point> points = even_cover(space, 256, 7);
  ASSERT_EQ(points.size(), 256U);
  for (size_t i = 0; i < space.size(); ++i) {
    std::array<int, 8> counts{};
    for (const Point& point : points) ++counts[static_cast<size_t>(8 * point[i])];
    for (const int count : counts) EXPECT_NEAR(count, 32, 3);
  }
}

TEST(SearchSpace, values_have_four_digits_and_keep_to_the_ends) {
  const SearchAxis axis = side("combine.k_depth", 1e-4, 0.1, Scale::log);
  EXPECT_EQ(to_text(value_at(axis, 0)), "0.0001");
  EXPECT_EQ(to_text(value_at(axis, 1)), "0.1");
  EXPECT_EQ(to_text(value_at(axis, 0.5)), "0.003162");
  EXPECT_NEAR(share_of(axis, value_at(axis, 0.37)), 0.37, 1e-4);
}

std::string spec_error(const std::string& body) {
  return error_of([&] { parse_tune_spec(body, "/searches/s.toml"); });
}

TEST(TuneSpec, sides_are_the_sliders_and_all_choices_unless_told) {
  const TuneSpec spec = parse_tune_spec(
      "[[search]]\nkey = \"combine.k_depth\"\n[[search]]\nkey = \"edges.method\"\n"
      "[[search]]\nkey = \"combine.k_normal\"\nfrom = 0.01\nto = 0.2\nscale = \"linear\"\n",
      "/searches/s.toml");
  ASSERT_EQ(spec.space.size(), 3U);
  EXPECT_DOUBLE_EQ(spec.space[0].from, 1e-4);
  EXPECT_EQ(spec.space[0].scale, Scale::log);
  EXPECT_EQ(spec.space[1].choices.size(), ChoiceNames<EdgeMethod>::names.size());
  EXPECT_DOUBLE_EQ(spec.space[2].to, 0.2);
  EXPECT_EQ(spec.objective.text(), "f1");
}

TEST(TuneSpec, groups_times_views_are_the_pictures) {
  const TuneSpec spec = parse_tune_spec(
      "[[search]]\nkey = \"combine.k_depth\"\n[[group]]\nname = \"a\"\n[[group]]\nname = \"b\"\n"
      "[group.set]\nmodel.rabbit.shape = \"box\"\n[[view]]\nname = \"front\"\n[[view]]\nname = \"side\"\n"
      "[view.set]\ncamera.eye = [9, 3, 3]\n",
      "/searches/s.toml");
  EXPECT_EQ(spec.groups, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(spec.pictures.size(), 4U);
  EXPECT_EQ(spec.pictures[3].name, "b_side");
  EXPECT_EQ(spec.pictures[3].group, 1U);
  EXPECT_EQ(spec.pictures[3].set.size(), 2U);
}

TEST(TuneSpec, all_bundled_ones_load_and_say_what_they_are_for) {
  int specs = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(project_file("studies/tuning"))) {
    if (entry.path().extension() != ".toml") continue;
    ++specs;
    const TuneSpec spec = load_tune_spec(entry.path());
    EXPECT_FALSE(spec.purpose.empty()) << entry.path();
  }
  EXPECT_GE(specs, 7);
}

TEST(TuneSpec, what_cannot_be_searched_is_named_with_its_line) {
  EXPECT_THAT(spec_error("title = \"x\"\n"), HasSubstr("s.toml: has no [[search]]"));
  EXPECT_THAT(spec_error("[[search]]\nkey = \"combine.k_dept\"\n"), HasSubstr("s.toml:2: unknown parameter"));
  EXPECT_THAT(spec_error("[[search]]\nkey = \"camera.eye\"\n"),
              HasSubstr("s.toml:2: camera.eye is a vector"));
  EXPECT_THAT(spec_error("[[search]]\nkey = \"combine.k_depth\"\nfrom = 0.2\nto = 0.1\n"),
              HasSubstr("from must be below to"));
  EXPECT_THAT(spec_error("[[search]]\nkey = \"combine.k_depth\"\nfrom = -1\n"), HasSubstr("s.toml:3"));
  EXPECT_THAT(spec_error("budget = 3\n[[search]]\nkey = \"combine.k_depth\"\n"),
              HasSubstr("s.toml:1: budget = 3; it must be a whole number from 10"));
  EXPECT_THAT(spec_error("[[search]]\nkey = \"combine.k_depth\"\n[objective]\nink = 1\n"),
              HasSubstr("neither more nor less of ink is better"));
  EXPECT_THAT(spec_error("[[search]]\nkey = \"combine.k_depth\"\n[objective]\nflicker = 1\n"),
              HasSubstr("needs more than single views"));
  EXPECT_THAT(
      spec_error("[[search]]\nkey = \"combine.k_depth\"\n[objective]\nconstraints = [\"recall > 1\"]\n"),
      HasSubstr("has neither >= nor <="));
  EXPECT_THAT(
      spec_error(
          "[[search]]\nkey = \"camera.eye.x\"\n[[view]]\nname = \"a\"\n[view.set]\ncamera.eye = [1, 2, 3]\n"),
      HasSubstr("camera.eye.x is searched, and a sets it"));
}

}  // namespace
}  // namespace inkbench
