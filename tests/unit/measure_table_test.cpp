// SPDX-License-Identifier: MIT
// The table of measures: whole rows, and what they make a meter find out.
#include <gtest/gtest.h>

#include <set>

#include "studies/measures/measures.h"

namespace inkbench {
namespace {

MeasureNeeds needs_of(std::string_view key) {
  MeasureNeeds needs;
  needs.add(*find_measure(key));
  return needs;
}

TEST(MeasureTable, every_row_is_whole) {
  std::set<std::string> keys;
  for (const Measure& measure : measure_table()) {
    EXPECT_TRUE(keys.insert(measure.key).second) << measure.key << " is there twice";
    EXPECT_TRUE(measure.help.ends_with('.')) << measure.key;
    EXPECT_FALSE(measure.label.empty()) << measure.key;
    ASSERT_NE(measure.value, nullptr) << measure.key;
    EXPECT_EQ(measure.needs == Need::reference_class, measure.line_class.has_value()) << measure.key;
  }
}

TEST(MeasureTable, there_is_a_recall_for_each_class_and_it_reads_its_own) {
  DrawingTally tally;
  for (size_t i = 0; i < kLineClasses.size(); ++i) tally.recall[i] = {static_cast<int64_t>(i), 10};
  for (size_t i = 0; i < kLineClasses.size(); ++i) {
    const Measure* recall = find_measure("recall_" + std::string(kLineClassNames[i]));
    ASSERT_NE(recall, nullptr);
    EXPECT_EQ(recall->line_class, kLineClasses[i]);
    EXPECT_EQ(recall->value(tally), static_cast<double>(i) / 10);
  }
}

TEST(MeasureTable, what_was_not_tallied_has_no_value) {
  for (const Measure& measure : measure_table()) {
    const bool is_part = measure.needs == Need::reference_class || measure.of_level();
    if (is_part) {
      EXPECT_EQ(measure.value({}), std::nullopt) << measure.key;
    }
  }
}

TEST(MeasureTable, drawn_lines_alone_need_no_reference_lines) {
  for (const char* key : {"faces", "ink", "ink_px", "predicted", "components", "thickness_px"})
    EXPECT_FALSE(needs_of(key).reference_lines()) << key;
  for (const char* key : {"f1", "empty", "jaggedness_px", "recall_crease", "f1_geometry", "internal_new"})
    EXPECT_TRUE(needs_of(key).reference_lines()) << key;
}

TEST(MeasureTable, only_measures_of_a_level_need_the_full_mesh) {
  for (const Measure& measure : measure_table())
    EXPECT_EQ(needs_of(measure.key).full_mesh(), measure.of_level()) << measure.key;
}

TEST(MeasureTable, an_old_name_leads_to_the_one_that_is_there) {
  EXPECT_EQ(find_measure("f1_detector"), nullptr);
  EXPECT_NE(find_measure(renamed_measure("f1_detector")), nullptr);
  EXPECT_EQ(renamed_measure("f1"), "");
}

TEST(MeasureTable, texts_read_back_and_tell_kinds_apart) {
  DrawingTally tally;
  tally.pixels = 3;
  tally.ink = 1;
  EXPECT_EQ(measure_text(*find_measure("ink"), tally), "0.3333333333333333");
  EXPECT_EQ(measure_text(*find_measure("ink_px"), tally), "1");
  EXPECT_EQ(measure_text(*find_measure("empty"), tally), "true");
  EXPECT_EQ(measure_text(*find_measure("recall_ridge"), tally), "");
}

}  // namespace
}  // namespace inkbench
