// SPDX-License-Identifier: MIT
// Undo and redo: every change comes back exactly; an edit is one step; memory stays bounded.
#include "app/workbench/history.h"

#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Settings with_k(float k) {
  Settings settings = paper_settings();
  settings.combine.k_depth = k;
  return settings;
}

TEST(History, starts_with_nothing_to_undo) {
  History history(paper_settings());
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.undo_name(), "");
  EXPECT_EQ(history.redo_name(), "");
  EXPECT_EQ(text(history.undo()), text(paper_settings()));
  EXPECT_EQ(text(history.redo()), text(paper_settings()));
}

TEST(History, undoes_and_redoes_a_change_with_its_name) {
  History history(paper_settings());
  EXPECT_TRUE(history.record(with_k(0.001F)));
  EXPECT_TRUE(history.can_undo());
  EXPECT_EQ(history.undo_name(), "combine.k_depth 0.003 -> 0.001");
  EXPECT_EQ(text(history.undo()), text(paper_settings()));
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(history.redo_name(), "combine.k_depth 0.003 -> 0.001");
  EXPECT_EQ(text(history.redo()), text(with_k(0.001F)));
  EXPECT_FALSE(history.can_redo());
}

TEST(History, a_given_name_is_kept) {
  History history(paper_settings());
  history.record(with_k(0.001F), "Load preset fine");
  EXPECT_EQ(history.undo_name(), "Load preset fine");
}

TEST(History, equal_settings_make_no_step_and_keep_what_can_be_redone) {
  History history(paper_settings());
  history.record(with_k(0.001F));
  history.undo();
  EXPECT_FALSE(history.record(paper_settings()));
  EXPECT_TRUE(history.can_redo());
  EXPECT_EQ(text(history.redo()), text(with_k(0.001F)));
}

TEST(History, a_new_change_cuts_off_what_was_undone) {
  History history(paper_settings());
  for (const float k : {0.01F, 0.02F, 0.03F}) history.record(with_k(k));
  history.undo();
  history.undo();
  history.record(with_k(0.5F));
  EXPECT_FALSE(history.can_redo());
  EXPECT_THAT(history.step_names(),
              ElementsAre("combine.k_depth 0.003 -> 0.01", "combine.k_depth 0.01 -> 0.5"));
  EXPECT_EQ(history.undo().combine.k_depth, 0.01F);
  EXPECT_EQ(history.undo().combine.k_depth, 0.003F);
}

TEST(History, a_drag_is_one_step) {
  History history(paper_settings());
  history.begin_edit();
  for (int i = 1; i <= 100; ++i) {
    history.update_edit(with_k(0.003F + 0.001F * static_cast<float>(i)));
    EXPECT_EQ(history.current().combine.k_depth, 0.003F + 0.001F * static_cast<float>(i));
  }
  EXPECT_TRUE(history.is_editing());
  EXPECT_TRUE(history.end_edit());
  EXPECT_FALSE(history.is_editing());
  EXPECT_THAT(history.step_names(), ElementsAre("combine.k_depth 0.003 -> 0.103"));
  EXPECT_EQ(text(history.undo()), text(paper_settings()));
}

TEST(History, a_drag_back_to_its_start_is_no_step) {
  History history(paper_settings());
  history.record(with_k(0.5F));
  history.undo();
  history.begin_edit();
  history.update_edit(with_k(0.9F));
  EXPECT_FALSE(history.can_redo()) << "while something else is being edited";
  history.update_edit(paper_settings());
  EXPECT_FALSE(history.end_edit());
  EXPECT_FALSE(history.can_undo());
  EXPECT_TRUE(history.can_redo());
}

TEST(History, undo_in_the_middle_of_a_drag_takes_the_drag_back) {
  History history(paper_settings());
  history.begin_edit("Drag");
  history.update_edit(with_k(0.9F));
  EXPECT_TRUE(history.can_undo());
  EXPECT_EQ(history.undo_name(), "Drag");
  EXPECT_EQ(text(history.undo()), text(paper_settings()));
  EXPECT_FALSE(history.is_editing());
  EXPECT_EQ(text(history.redo()), text(with_k(0.9F)));
}

TEST(History, beginning_an_edit_ends_the_one_before) {
  History history(paper_settings());
  history.begin_edit();
  history.update_edit(with_k(0.1F));
  history.begin_edit();
  history.update_edit(with_k(0.2F));
  history.end_edit();
  EXPECT_EQ(history.undo().combine.k_depth, 0.1F);
  EXPECT_EQ(history.undo().combine.k_depth, 0.003F);
}

TEST(History, an_edit_that_is_cancelled_was_never_made) {
  History history(paper_settings());
  history.record(with_k(0.1F));
  history.undo();
  history.begin_edit();
  history.update_edit(with_k(0.2F));
  history.cancel_edit();
  EXPECT_FALSE(history.is_editing());
  EXPECT_EQ(history.current().combine.k_depth, 0.003F);
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(history.redo().combine.k_depth, 0.1F) << "what could be redone still can";
}

TEST(History, records_inside_an_edit_belong_to_it) {
  History history(paper_settings());
  history.begin_edit();
  history.record(with_k(0.1F));
  history.record(with_k(0.2F));
  history.end_edit();
  EXPECT_EQ(history.step_names().size(), 1U);
}

TEST(History, models_that_come_and_go_are_undone) {
  Settings more = paper_settings();
  more.models.emplace_back().name = "new";
  more.combine.k_depth = 0.5F;
  Settings fewer = more;
  fewer.models.erase(fewer.models.begin());
  History history(paper_settings());
  history.record(more);
  history.record(fewer, "Remove rabbit");
  EXPECT_EQ(text(history.undo()), text(more));
  EXPECT_EQ(text(history.undo()), text(paper_settings()));
  EXPECT_EQ(text(history.redo()), text(more));
  EXPECT_EQ(text(history.redo()), text(fewer));
}

TEST(History, goes_to_any_step) {
  History history(paper_settings());
  for (int i = 1; i <= 9; ++i) history.record(with_k(0.1F * static_cast<float>(i)));
  EXPECT_EQ(history.go_to(3).combine.k_depth, 0.1F * 3.0F);
  EXPECT_EQ(history.position(), 3U);
  EXPECT_EQ(history.go_to(0).combine.k_depth, 0.003F);
  EXPECT_EQ(history.go_to(99).combine.k_depth, 0.1F * 9.0F);
  EXPECT_EQ(history.position(), 9U);
}

TEST(History, forgets_the_oldest_steps_past_its_limit) {
  History history(paper_settings(), {.steps = 3});
  for (int i = 1; i <= 10; ++i) history.record(with_k(0.01F * static_cast<float>(i)));
  EXPECT_EQ(history.step_names().size(), 3U);
  for (int i = 0; i < 5; ++i) history.undo();
  EXPECT_EQ(history.current().combine.k_depth, 0.01F * 7.0F);
}

TEST(History, whole_scenes_are_held_to_a_limit_of_bytes) {
  Settings many = paper_settings();
  for (int i = 0; i < 1000; ++i) many.models.emplace_back().name = "m" + std::to_string(i);
  History history(paper_settings(), {.bytes = size_t{2} << 20});
  for (int i = 0; i < 30; ++i) {
    history.record(many);
    many.models.pop_back();
  }
  EXPECT_LT(history.step_names().size(), 20U);
  EXPECT_GT(history.step_names().size(), 1U);
  const Settings last = history.current();
  history.undo();
  EXPECT_EQ(text(history.redo()), text(last));
}

TEST(History, a_step_larger_than_the_limit_is_kept_alone) {
  History history(paper_settings(), {.bytes = 1});
  history.record(with_k(0.1F));
  history.record(with_k(0.2F));
  EXPECT_EQ(history.step_names().size(), 1U);
  EXPECT_EQ(history.undo().combine.k_depth, 0.1F);
}

TEST(History, a_long_walk_to_and_fro_ends_where_it_should) {
  // Random changes of random parameters, undo and redo, against a plain list of whole texts.
  Settings settings = paper_settings();
  History history(settings);
  std::vector<std::string> texts{text(settings)};
  size_t at = 0;
  uint32_t seed = 7;
  const auto random = [&](uint32_t below) { return (seed = seed * 1664525U + 1013904223U) / 65536U % below; };
  for (int i = 0; i < 400; ++i) {
    const uint32_t choice = random(8);
    if (choice == 0 && at > 0) {
      --at;
      settings = history.undo();
    } else if (choice == 1 && at + 1 < texts.size()) {
      ++at;
      settings = history.redo();
    } else {
      const std::vector<Param> params = list_params(settings);
      const Param param = params[random(static_cast<uint32_t>(params.size()))];
      if (param.field->type != FieldType::real) continue;
      param.field->set(param.owner, static_cast<float>(random(1000)) / 7.0F);
      if (text(settings) == texts[at]) continue;
      history.record(settings);
      texts.resize(++at);
      texts.push_back(text(settings));
    }
    ASSERT_EQ(text(history.current()), texts[at]) << "step " << i;
  }
  EXPECT_GT(texts.size(), 20U);
}

TEST(History, where_settings_came_from_comes_back_with_them) {
  History history(paper_settings());
  EXPECT_EQ(history.origin(), 0U);
  EXPECT_TRUE(history.record_from(1, with_k(0.001F), "open a"));
  history.record(with_k(0.002F));
  EXPECT_TRUE(history.record_from(2, with_k(0.003F + 0.001F), "open b"));
  EXPECT_EQ(history.origin(), 2U);
  history.undo();
  EXPECT_EQ(history.origin(), 1U);
  history.go_to(0);
  EXPECT_EQ(history.origin(), 0U);
  history.go_to(3);
  EXPECT_EQ(history.origin(), 2U);
}

TEST(History, another_origin_of_equal_settings_is_no_step) {
  History history(paper_settings());
  history.record(with_k(0.001F));
  history.undo();
  EXPECT_FALSE(history.record_from(1, paper_settings(), "save"));
  EXPECT_EQ(history.origin(), 1U);
  EXPECT_TRUE(history.can_redo());
}

}  // namespace
}  // namespace inkbench
