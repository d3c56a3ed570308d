// SPDX-License-Identifier: MIT
// Causes from hand-made evidence: each by its rule, the first that applies, and counts that add up.
#include "studies/measures/causes.h"

#include <gtest/gtest.h>

#include "studies/measures/distance.h"
#include "studies/measures/tally.h"
#include "tests/unit/line_map_support.h"

namespace inkbench {
namespace {

constexpr int kSide = 40;

LineMap dots(std::initializer_list<Pixel> pixels) {
  LineMap map(kSide, kSide);
  for (const Pixel& pixel : pixels) map.set(pixel.x, pixel.y);
  return map;
}

LineMap everywhere() {
  LineMap map(kSide, kSide);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) map.set(x, y);
  }
  return map;
}

/// One false pixel at (20, 20), or one missed there, and no other line.
CauseEvidence evidence_of(const LineMap& wrong, const LineMap& missed) {
  CauseEvidence evidence;
  evidence.maps.wrong = wrong;
  evidence.maps.missed = missed;
  evidence.maps.matched = evidence.maps.allowed = dots({});
  evidence.reference = evidence.drawn = evidence.objects = dots({});
  return evidence;
}
CauseEvidence false_at_20() {
  return evidence_of(dots({{20, 20}}), dots({}));
}
CauseEvidence missed_at_20(float strength_at_22) {
  CauseEvidence evidence = evidence_of(dots({}), dots({{20, 20}}));
  evidence.strength = Image(kSide, kSide, 1);
  evidence.strength->at(22, 20) = strength_at_22;
  return evidence;
}

Cause cause_of(const CauseEvidence& evidence) {
  return find_causes(evidence).at(20, 20);
}

TEST(Causes, a_false_pixel_within_twice_the_tolerance_of_a_reference_line_is_doubled) {
  CauseEvidence evidence = false_at_20();
  evidence.reference = dots({{24, 20}});
  EXPECT_EQ(cause_of(evidence), Cause::doubled);
  evidence.reference = dots({{24, 21}});
  EXPECT_EQ(cause_of(evidence), Cause::other_false);
}

TEST(Causes, a_line_is_gone_where_the_other_drawing_has_none_beside_it_either) {
  CauseEvidence evidence = false_at_20();
  evidence.float_buffers = dots({{21, 21}});
  EXPECT_EQ(cause_of(evidence), Cause::other_false);
  evidence.float_buffers = dots({{22, 20}});
  EXPECT_EQ(cause_of(evidence), Cause::quantised);
}

TEST(Causes, seams_are_what_one_normal_a_vertex_takes_away) {
  CauseEvidence evidence = false_at_20();
  evidence.smooth_normals = dots({});
  EXPECT_EQ(cause_of(evidence), Cause::seam);
  evidence.smooth_normals = dots({{20, 20}});
  EXPECT_EQ(cause_of(evidence), Cause::other_false);
}

TEST(Causes, facets_lie_along_edges_that_bend_and_go_with_smooth_normals) {
  CauseEvidence evidence = false_at_20();
  evidence.slight_bends = dots({{22, 20}});
  EXPECT_EQ(cause_of(evidence), Cause::other_false) << "nothing was drawn again";
  evidence.unfaceted = dots({});
  EXPECT_EQ(cause_of(evidence), Cause::facet);
  evidence.slight_bends = dots({{23, 20}});
  EXPECT_EQ(cause_of(evidence), Cause::other_false);
}

TEST(Causes, a_surfaces_edge_is_a_facet_where_it_stays_at_twice_the_size_and_a_bend_where_it_goes) {
  CauseEvidence evidence = false_at_20();
  evidence.slight_bends = dots({{20, 20}});
  evidence.reads_surface = true;
  evidence.twice_as_large = LineMap(2 * kSide, 2 * kSide);
  EXPECT_EQ(cause_of(evidence), Cause::bend);
  evidence.twice_as_large->set(41, 41);
  EXPECT_EQ(cause_of(evidence), Cause::facet);
}

TEST(Causes, grazing_needs_a_flat_place_and_a_line_that_goes_with_the_depth_term) {
  CauseEvidence evidence = false_at_20();
  evidence.even = dots({{20, 20}});
  evidence.no_depth_term = dots({});
  EXPECT_EQ(cause_of(evidence), Cause::grazing);
  evidence.even = dots({});
  EXPECT_EQ(cause_of(evidence), Cause::other_false);
  evidence.even = everywhere();
  evidence.no_depth_term = dots({{19, 20}});
  EXPECT_EQ(cause_of(evidence), Cause::other_false);
}

TEST(Causes, a_bend_is_gone_in_all_pixels_of_twice_the_size_that_become_its_own) {
  CauseEvidence evidence = false_at_20();
  for (const Pixel& beside : {Pixel{38, 40}, Pixel{43, 43}}) {
    evidence.twice_as_large = LineMap(2 * kSide, 2 * kSide);
    evidence.twice_as_large->set(beside.x, beside.y);
    EXPECT_EQ(cause_of(evidence), Cause::other_false) << beside.x;
  }
  evidence.twice_as_large = LineMap(2 * kSide, 2 * kSide);
  evidence.twice_as_large->set(44, 40);
  EXPECT_EQ(cause_of(evidence), Cause::bend);
}

TEST(Causes, the_first_that_applies_is_given) {
  CauseEvidence evidence = false_at_20();
  evidence.twice_as_large = LineMap(2 * kSide, 2 * kSide);
  EXPECT_EQ(cause_of(evidence), Cause::bend);
  evidence.even = everywhere();
  evidence.no_depth_term = dots({});
  EXPECT_EQ(cause_of(evidence), Cause::grazing);
  evidence.slight_bends = everywhere();
  evidence.unfaceted = dots({});
  EXPECT_EQ(cause_of(evidence), Cause::facet);
  evidence.smooth_normals = dots({});
  EXPECT_EQ(cause_of(evidence), Cause::seam);
  evidence.float_buffers = dots({});
  EXPECT_EQ(cause_of(evidence), Cause::quantised);
  evidence.reference = everywhere();
  EXPECT_EQ(cause_of(evidence), Cause::doubled);
}

TEST(Causes, a_missed_pixel_with_a_line_within_twice_the_tolerance_is_displaced) {
  CauseEvidence evidence = missed_at_20(0);
  evidence.drawn = dots({{20, 24}});
  EXPECT_EQ(cause_of(evidence), Cause::displaced);
  evidence.drawn = dots({{21, 24}});
  EXPECT_EQ(cause_of(evidence), Cause::no_signal);
}

TEST(Causes, only_ids_tell_an_object_border_without_a_signal) {
  CauseEvidence evidence = missed_at_20(0.005F);
  evidence.objects = dots({{20, 21}});
  EXPECT_EQ(cause_of(evidence), Cause::same_id);
  evidence.tells_objects = true;
  EXPECT_EQ(cause_of(evidence), Cause::no_signal);
  evidence.tells_objects = false;
  evidence.strength->at(20, 20) = 0.02F;
  EXPECT_EQ(cause_of(evidence), Cause::under_the_limit);
}

TEST(Causes, strength_within_the_tolerance_tells_no_signal_from_too_little_and_by_what_factor) {
  EXPECT_EQ(cause_of(missed_at_20(0.0099F)), Cause::no_signal);
  const CauseEvidence weak = missed_at_20(0.25F);
  const CauseMaps causes = find_causes(weak);
  EXPECT_EQ(causes.at(20, 20), Cause::under_the_limit);
  EXPECT_EQ(causes.missing_factor.at(20, 20), 4.0F);
  EXPECT_EQ(cause_of(missed_at_20(1.0F)), Cause::other_missed);
  CauseEvidence farther = weak;
  farther.tolerance_px = 1;
  EXPECT_EQ(cause_of(farther), Cause::no_signal);
}

TEST(Causes, a_pixel_may_be_false_and_missed_and_both_are_counted) {
  const CauseMaps causes = find_causes(evidence_of(dots({{5, 5}}), dots({{5, 5}})));
  EXPECT_EQ(causes.at(5, 5), Cause::other_false);
  EXPECT_EQ(count_causes(causes).of(Cause::other_false), 1);
  EXPECT_EQ(count_causes(causes).of(Cause::other_missed), 1);
}

TEST(Causes, the_nearest_caused_pixel_answers_for_those_beside_it) {
  const CauseMaps causes = find_causes(evidence_of(dots({{20, 20}}), dots({{25, 20}})));
  ASSERT_TRUE(cause_near(causes, 22, 20, 2));
  EXPECT_EQ(cause_near(causes, 22, 20, 2)->x, 20);
  EXPECT_EQ(cause_near(causes, 23, 20, 2)->cause, Cause::other_missed);
  EXPECT_FALSE(cause_near(causes, 22, 22, 2));
  EXPECT_FALSE(cause_near(causes, 0, 0, 2));
}

TEST(Causes, false_pixels_are_as_many_as_precision_counts_whatever_ties_there_are) {
  for (uint32_t seed = 0; seed < 40; ++seed) {
    const LineMap drawn = random_map(60, 50, 0.05, seed), wanted = random_map(60, 50, 0.03, seed + 100),
                  allowed = random_map(60, 50, 0.02, seed + 200);
    const LineTally tally = tally_lines({.prediction = drawn, .reference = wanted, .allowed = &allowed});
    CauseEvidence evidence;
    evidence.maps = match_maps({drawn, wanted, allowed, {}});
    evidence.reference = evidence.objects = LineMap(60, 50);
    evidence.drawn = drawn;
    EXPECT_EQ(evidence.maps.matched.count(), tally.at_tolerance.matched) << seed;
    EXPECT_EQ(evidence.maps.matched.count() + evidence.maps.allowed.count(), tally.at_tolerance.allowed);
    const CauseMaps causes = find_causes(evidence);
    int64_t of_false = 0, of_missed = 0;
    for (const CauseInfo& info : cause_table())
      (info.is_of_missed() ? of_missed : of_false) += count_causes(causes).of(info.cause);
    EXPECT_EQ(of_false, tally.predicted - tally.at_tolerance.allowed) << seed;
    EXPECT_EQ(of_missed, tally.referenced - tally.at_tolerance.matched) << seed;
  }
}

TEST(Causes, each_has_its_own_key_and_colour) {
  for (const CauseInfo& a : cause_table()) {
    EXPECT_EQ(&info_of(a.cause), &a);
    EXPECT_TRUE(a.key.starts_with(a.is_of_missed() ? "missed_" : "false_")) << a.key;
    for (const CauseInfo& b : cause_table()) {
      if (&a == &b) continue;
      EXPECT_NE(a.key, b.key);
      EXPECT_NE(a.colour, b.colour) << a.key << b.key;
    }
  }
}

}  // namespace
}  // namespace inkbench
