// SPDX-License-Identifier: MIT
// What would draw a pixel and what would remove one: set alone and drawn again, and a little less.
#include "pipeline/deciding_values.h"

#include <gtest/gtest.h>

#include "pipeline/explain.h"
#include "tests/gl/detector_support.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

class DecidingValues : public testing::Test {
 protected:
  bool is_drawn(const Settings& settings, int x, int y) {
    const Frame frame = pipeline_.at(settings);
    const float decided = frame.pixel(edge_detector(settings).decided(), x, y).at(0, 0);
    if (settings.edges.method == EdgeMethod::paper) return decided != 0;
    // A pixel alone is no line of dihedral's, whatever its strength.
    const bool is_dot = settings.edges.method == EdgeMethod::dihedral && !explain_pixel(frame, x, y).is_line;
    return decided >= 1 && !is_dot;
  }

  static Settings with(Settings settings, const std::string& key, const Value& value) {
    find_param(settings, key, "test").set(value, "test");
    return settings;
  }

  /// The value changes the pixel as it was drawn; one 2 % nearer to the present one does not.
  void expect_decides(const Settings& settings, int x, int y, const ExplainedChange& change) {
    const bool was_drawn = is_drawn(settings, x, y);
    const auto what = [&] {
      return change.parameter + " = " + to_text(change.value) + " at " + std::to_string(x) + ", " +
             std::to_string(y);
    };
    EXPECT_NE(is_drawn(with(settings, change.parameter, change.value), x, y), was_drawn) << what();
    if (!std::holds_alternative<float>(change.value)) return;
    const float value = std::get<float>(change.value), now = std::get<float>(change.now);
    const float less = value > now ? std::max(value * 0.98F, now) : std::min(value * 1.02F, now);
    EXPECT_EQ(is_drawn(with(settings, change.parameter, less), x, y), was_drawn) << what() << " or less";
  }

  /// A few pixels of every row; returns how many values drew and how many removed.
  std::pair<int, int> try_all(const Settings& settings) {
    int drew = 0, removed = 0;
    const Frame frame = pipeline_.at(settings);
    for (int y = 3; y < settings.image.height - 3; y += 17) {
      for (int x = 4; x < settings.image.width - 3; x += 7) {
        const Explanation why = explain_pixel(frame, x, y);
        for (const ExplainedChange& change : why.changes) {
          expect_decides(settings, x, y, change);
          ++(why.is_line ? removed : drew);
        }
      }
    }
    return {drew, removed};
  }

  Pipeline pipeline_;
};

TEST_F(DecidingValues, each_alone_changes_the_pixel_and_a_little_less_does_not_with_every_method) {
  std::vector<EdgeMethod> methods = other_methods();
  methods.push_back(EdgeMethod::paper);
  methods.push_back(EdgeMethod::dihedral);
  for (const EdgeMethod method : methods) {
    SCOPED_TRACE(name_of_method(method));
    Settings settings = paper_scene(96, 80);
    settings.edges.method = method;
    const auto [drew, removed] = try_all(settings);
    EXPECT_GT(drew, 5);
    EXPECT_GT(removed, 0);
  }
}

TEST_F(DecidingValues, a_term_that_is_off_is_named_by_its_switch) {
  Settings settings = analytic_scene();
  settings.combine.use_depth = false;
  const Image with_depth = pipeline_.at(analytic_scene()).raw(BufferName::combined_edges);
  const Frame frame = pipeline_.at(settings);
  int named = 0;
  for (int x = 5; x < settings.image.width - 5; ++x) {
    for (const ExplainedChange& change : explain_pixel(frame, x, 60).changes) {
      if (change.parameter != "combine.use_depth") continue;
      EXPECT_EQ(change.value, Value(true));
      EXPECT_GT(with_depth.at(x, 60), 0);
      ++named;
    }
  }
  EXPECT_GT(named, 0);
}

TEST_F(DecidingValues, no_single_limit_draws_where_a_capped_term_cannot_reach_the_threshold) {
  Settings settings = analytic_scene();
  settings.combine.threshold = 2;  // both terms at their most
  settings.combine.use_normal = false;
  for (const ExplainedChange& change : explain_pixel(pipeline_.at(settings), 40, 60).changes)
    EXPECT_EQ(change.parameter, "combine.threshold");
}

TEST_F(DecidingValues, text_and_json_name_the_parameter_its_value_and_the_present_one) {
  Explanation why;
  why.changes = {{"combine.k_depth", 0.0021F, 0.003F}, {"combine.use_normal", true, false}};
  EXPECT_NE(explanation_text(why).find("Would draw it:\n  combine.k_depth = 0.0021  (now 0.003)\n"),
            std::string::npos);
  EXPECT_NE(explanation_json(why).find("\"combine.use_normal\",\"value\":true,\"now\":false"),
            std::string::npos);
  why.is_line = true;
  EXPECT_NE(explanation_text(why).find("Would remove it:"), std::string::npos);
  why.changes.clear();
  EXPECT_NE(explanation_text(why).find("No useful value of a single limit would remove it."),
            std::string::npos);
}

}  // namespace
}  // namespace inkbench
