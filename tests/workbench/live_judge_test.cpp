// SPDX-License-Identifier: MIT
// Measuring in the background: the same numbers as in the foreground, the newest request wins, nothing
// blocks.
#include "app/workbench/live_judge.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <glm/trigonometric.hpp>

#include "studies/judging/measured_lines.h"
#include "studies/measures/diff_picture.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::HasSubstr;
using Clock = std::chrono::steady_clock;

/// A circle of `radius` as silhouette, and a crease across.
std::shared_ptr<const ReferenceLines> circle_lines(int size_px, float radius) {
  auto lines = std::make_shared<ReferenceLines>();
  lines->width_px = lines->height_px = size_px;
  const float middle = static_cast<float>(size_px) / 2;
  Polyline circle{LineClass::silhouette, 1, {}};
  for (int i = 0; i <= 360; ++i) {
    const float angle = glm::radians(static_cast<float>(i % 360));
    circle.points.emplace_back(middle + radius * std::cos(angle), middle + radius * std::sin(angle));
  }
  const Polyline crease{LineClass::crease, 1, {{middle - radius, middle}, {middle + radius, middle}}};
  lines->polylines = {circle, crease};
  lines->whole_creases = {crease};
  return lines;
}

/// Edges along some of the lines.
std::shared_ptr<const Image> edges_along(const ReferenceLines& lines,
                                         std::initializer_list<LineClass> classes) {
  auto edges = std::make_shared<Image>(lines.width_px, lines.height_px, 1);
  for (const LineClass line_class : classes) {
    for_each_pixel(class_map(lines, line_class), [&](int x, int y) { edges->at(x, y) = 1.0F; });
  }
  return edges;
}

JudgeRequest judge_request(uint64_t id, int size_px = 96) {
  const auto lines = circle_lines(size_px, static_cast<float>(size_px) / 3);
  return {.id = id, .view = {edges_along(*lines, {LineClass::silhouette}), lines}};
}

double value(const Judgement& judgement, std::string_view key) {
  return find_measure(key)->value(judgement.tally).value();
}

std::string json_of(const Judgement& judgement) {
  return measures_json(all_measures(), judgement.tally);
}

void ask(LiveJudge& live, const JudgeRequest& wanted) {
  live.ask(KeyBuilder().add(std::to_string(wanted.id)).key(), [&] { return wanted; });
}

/// Waits for a result; none after half a minute.
std::optional<Judgement> wait_for_judgement(LiveJudge& live) {
  const auto end = Clock::now() + std::chrono::seconds(30);
  while (Clock::now() < end) {
    if (std::optional<Judgement> result = live.take()) return result;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return std::nullopt;
}

TEST(Judge, equals_the_measures_of_a_study) {
  const JudgeRequest asked = judge_request(7);
  const Judgement result = judge(asked);
  const LineView view = line_view(line_map_from(*asked.view.edges), *asked.view.lines, {});
  const DrawingTally tally = tally_view({view, asked.view.lines.get()}, {}, MeasureNeeds::all());
  EXPECT_EQ(json_of(result), measures_json(all_measures(), tally));
  EXPECT_EQ(result.id, 7U);
  EXPECT_EQ(result.error, "");
  EXPECT_GT(result.seconds, 0);
  EXPECT_EQ(value(result, "precision"), 1.0);
  EXPECT_LT(value(result, "recall"), 0.95) << "the crease is not drawn";
  EXPECT_EQ(value(result, "recall_silhouette"), 1.0);
  EXPECT_LT(value(result, "recall_crease"), 0.2);
  EXPECT_FALSE(find_measure("recall_valley")->value(result.tally));
  EXPECT_FALSE(result.tally.ladder);
}

TEST(Judge, compares_with_the_full_mesh_where_it_is_given) {
  JudgeRequest asked = judge_request(1);
  asked.full = asked.view;
  const Judgement same = judge(asked);
  ASSERT_TRUE(same.tally.ladder);
  EXPECT_EQ(value(same, "f1_geometry"), 1.0);
  EXPECT_EQ(value(same, "f1_end_to_end"), value(same, "f1"));
}

TEST(Judge, maps_show_what_the_measures_count) {
  const auto lines = circle_lines(96, 30);
  auto edges = std::make_shared<Image>(*edges_along(*lines, {LineClass::silhouette}));
  for (int x = 10; x < 86; ++x) edges->at(x, 6) = 1.0F;  // a line where none should be
  const Judgement result = judge({.view = {edges, lines}});
  EXPECT_EQ(result.maps.matched.count(), value(result, "matched"));
  EXPECT_EQ(result.maps.missed.count(), value(result, "referenced") - value(result, "matched"));
  EXPECT_EQ(result.maps.wrong.count(), value(result, "predicted") - value(result, "matched"));
  EXPECT_TRUE(result.maps.wrong.at(40, 6));
  const Picture overlay = match_overlay(result.maps);
  EXPECT_EQ(overlay.at(40, 6, 0), kFalseColour[0]);
  EXPECT_EQ(overlay.at(40, 6, 3), 255);
  EXPECT_EQ(overlay.at(48, 20, 3), 0);
  EXPECT_EQ(overlay.at(48, 48, 2), kMissedColour[2]) << "the crease";
}

TEST(Judge, lines_of_tier_2_are_neither_right_nor_wrong) {
  auto lines = std::make_shared<ReferenceLines>(*circle_lines(96, 30));
  lines->polylines.push_back({LineClass::ridge, 1, {{10.5F, 6.5F}, {85.5F, 6.5F}}});
  const auto edges = edges_along(*lines, {LineClass::silhouette, LineClass::ridge});
  const Judgement result = judge({.view = {edges, lines}});
  EXPECT_EQ(result.maps.wrong.count(), 0);
  EXPECT_GT(result.maps.allowed.count(), 60);
  EXPECT_EQ(value(result, "precision"), 1.0);
}

TEST(Judge, what_does_not_fit_together_is_an_error) {
  JudgeRequest other_size = judge_request(1);
  other_size.view.lines = circle_lines(64, 20);
  EXPECT_THAT(error_of([&] { judge(other_size); }), HasSubstr("96 x 96 against 64 x 64"));
  error_of([&] { judge({}); });
  JudgeRequest tolerance = judge_request(1);
  tolerance.judge.tolerance = std::nanf("");
  EXPECT_THAT(error_of([&] { judge(tolerance); }), HasSubstr("give 0 to 100"));
}

TEST(LiveJudge, gives_each_result_once) {
  std::atomic<int> woken = 0;
  News news([&] { ++woken; });
  LiveJudge live(news);
  EXPECT_FALSE(live.take());
  EXPECT_FALSE(live.is_busy());
  ask(live, judge_request(3));
  const std::optional<Judgement> result = wait_for_judgement(live);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->id, 3U);
  EXPECT_EQ(json_of(*result), json_of(judge(judge_request(3))));
  EXPECT_FALSE(live.take());
  const auto end = Clock::now() + std::chrono::seconds(30);
  while (woken == 0 && Clock::now() < end) std::this_thread::yield();
  EXPECT_EQ(woken, 1);
}

TEST(LiveJudge, errors_come_back_as_results_and_the_next_request_works) {
  News news;
  LiveJudge live(news);
  JudgeRequest bad = judge_request(1);
  bad.view.lines = circle_lines(64, 20);
  ask(live, bad);
  const std::optional<Judgement> result = wait_for_judgement(live);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->id, 1U);
  EXPECT_THAT(result->error, HasSubstr("must have one size"));
  ask(live, judge_request(2));
  const std::optional<Judgement> next = wait_for_judgement(live);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->error, "");
}

/// News that hold the worker after its first result until it may go on.
struct HeldNews {
  std::atomic<int> results = 0;
  std::promise<void> first_is_done, may_go_on;
  News news{[this] {
    if (++results > 1) return;
    first_is_done.set_value();
    may_go_on.get_future().wait();
  }};
};

TEST(LiveJudge, asking_never_waits_and_the_newest_request_replaces_those_that_wait) {
  HeldNews held;
  LiveJudge live(held.news);
  ask(live, judge_request(1));
  held.first_is_done.get_future().wait();
  EXPECT_EQ(live.take()->id, 1U);
  for (uint64_t id = 2; id <= 50; ++id) ask(live, judge_request(id));
  held.may_go_on.set_value();
  const std::optional<Judgement> next = wait_for_judgement(live);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->id, 50U);
}

TEST(LiveJudge, ends_without_starting_what_waits) {
  HeldNews held;
  auto live = std::make_unique<LiveJudge>(held.news);
  ask(*live, judge_request(1));
  held.first_is_done.get_future().wait();
  ask(*live, judge_request(2));
  std::thread closer([&] { live.reset(); });
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // the closer waits for the worker by now
  held.may_go_on.set_value();
  closer.join();
  EXPECT_EQ(held.results, 1);
}

TEST(LiveJudge, a_stopped_judgement_skips_the_rest) {
  const Judgement result = judge(judge_request(1), [] { return true; });
  EXPECT_EQ(result.maps.matched.width_px(), 0);
  EXPECT_EQ(result.tally.recall[0].total, 0);
}

}  // namespace
}  // namespace inkbench
