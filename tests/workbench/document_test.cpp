// SPDX-License-Identifier: MIT
// The document: what changes it, what is refused, what undo brings back, what it is compared with.
#include "app/workbench/document.h"

#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kKey = "combine.k_depth";

class DocumentTest : public testing::Test {
 protected:
  float k_depth() const { return document_.settings().combine.k_depth; }
  std::string problem() const {
    const auto found = problems_.all().find(ProblemKind::input);
    return found == problems_.all().end() ? "" : found->second;
  }
  /// A scene file that differs from the settings in one parameter.
  fs::path scene_file() const {
    Settings settings = paper_settings();
    set(settings, kKey, 0.25F);
    return folder_.write("other.toml", settings_text(settings));
  }

  TemporaryFolder folder_;
  MessageLog log_;
  Problems problems_{log_};
  Settings start_ = paper_settings();
  Document document_{start_, project_file("data/scenes/paper.toml"), problems_};
};

TEST_F(DocumentTest, a_change_is_a_step_that_undo_takes_back_and_redo_brings_again) {
  const float before = k_depth();
  document_.change(kKey, 0.5F);
  EXPECT_EQ(k_depth(), 0.5F);
  document_.undo();
  EXPECT_EQ(k_depth(), before);
  document_.redo();
  EXPECT_EQ(k_depth(), 0.5F);
}

TEST_F(DocumentTest, a_value_that_is_not_accepted_is_a_problem_and_changes_nothing) {
  const long revision = document_.revision();
  document_.change(kKey, -1.0F);
  EXPECT_THAT(problem(), HasSubstr(kKey));
  EXPECT_EQ(text(document_.settings()), text(start_));
  EXPECT_EQ(document_.revision(), revision);
  EXPECT_FALSE(document_.history().can_undo());
}

TEST_F(DocumentTest, the_next_change_dismisses_the_problem) {
  document_.change_text(kKey, "much");
  ASSERT_NE(problem(), "");
  document_.change_text(kKey, "0.5");
  EXPECT_EQ(problem(), "");
  EXPECT_EQ(k_depth(), 0.5F);
}

TEST_F(DocumentTest, an_unknown_parameter_is_a_problem) {
  document_.change("combine.k_deep", 1.0F);
  EXPECT_THAT(problem(), HasSubstr("k_deep"));
}

TEST_F(DocumentTest, settings_with_one_bad_value_are_refused_whole) {
  Settings bad = start_;
  bad.combine.k_normal = 0.25F;
  bad.combine.k_depth = -1.0F;
  document_.replace(bad);
  EXPECT_NE(problem(), "");
  EXPECT_EQ(text(document_.settings()), text(start_));
}

TEST_F(DocumentTest, many_small_moves_are_one_step) {
  document_.begin_edit();
  for (const float value : {0.1F, 0.2F, 0.3F}) document_.change(kKey, value);
  EXPECT_TRUE(document_.is_editing());
  document_.end_edit();
  EXPECT_EQ(document_.history().step_names().size(), 1U);
  document_.undo();
  EXPECT_EQ(text(document_.settings()), text(start_));
}

TEST_F(DocumentTest, what_the_mouse_holds_is_not_undone) {
  document_.begin_edit();
  document_.change(kKey, 0.5F);
  document_.undo();
  EXPECT_EQ(k_depth(), 0.5F);
  EXPECT_TRUE(document_.is_editing());
}

TEST_F(DocumentTest, reset_gives_the_files_value_though_the_session_began_with_another) {
  Document document(start_, scene_file(), problems_);
  document.reset(kKey);
  EXPECT_EQ(document.settings().combine.k_depth, 0.25F);
}

TEST_F(DocumentTest, a_scene_that_is_gone_is_its_own_baseline) {
  const Document document(start_, folder_.path() / "gone.toml", problems_);
  EXPECT_EQ(text(document.baseline()), text(start_));
  EXPECT_EQ(document.scene_name(), "gone.toml");
  EXPECT_EQ(problem(), "");
}

TEST_F(DocumentTest, without_a_file_it_is_unnamed) {
  const Document document(start_, {}, problems_);
  EXPECT_EQ(document.scene_name(), "unnamed");
  EXPECT_EQ(document.scene(), "");
}

TEST_F(DocumentTest, undo_brings_back_where_the_settings_came_from) {
  EXPECT_TRUE(document_.take_over(load_settings(scene_file()), scene_file(), {}, "open other.toml"));
  EXPECT_EQ(document_.scene_name(), "other.toml");
  EXPECT_EQ(document_.baseline().combine.k_depth, 0.25F);
  document_.undo();
  EXPECT_EQ(document_.scene_name(), "paper.toml");
  EXPECT_EQ(text(document_.baseline()), text(start_));
}

TEST_F(DocumentTest, settings_that_cannot_be_a_scene_are_not_taken_over) {
  Settings bad = start_;
  bad.lights.at(0).type = LightType::directional;
  bad.lights.at(0).direction = glm::vec3(0.0F);
  EXPECT_FALSE(document_.take_over(bad, {}, {}, "bad"));
  EXPECT_THAT(problem(), HasSubstr("direction"));
  EXPECT_EQ(document_.scene_name(), "paper.toml");
}

TEST_F(DocumentTest, saved_settings_are_the_baseline_and_no_step) {
  document_.change(kKey, 0.5F);
  const long revision = document_.revision();
  document_.saved_as(folder_.path() / "mine.toml");
  EXPECT_EQ(document_.scene(), folder_.path() / "mine.toml");
  EXPECT_EQ(document_.baseline().combine.k_depth, 0.5F);
  EXPECT_EQ(document_.history().step_names().size(), 1U);
  EXPECT_GT(document_.revision(), revision) << "the session is to be saved again";
}

TEST_F(DocumentTest, accepting_throws_what_replacing_tells) {
  Settings bad = start_;
  bad.combine.k_depth = -1.0F;
  EXPECT_THAT(error_of([&] { document_.accept(bad, "bad"); }), HasSubstr(kKey));
  EXPECT_EQ(problem(), "");
}

TEST(Problems, the_same_problem_is_told_once_until_it_changes) {
  MessageLog log;
  Problems problems(log);
  for (const char* text : {"a", "a", "b", "a"}) problems.set(ProblemKind::input, text);
  std::vector<std::string> told;
  for (const Message& message : log.messages()) told.push_back(message.text);
  EXPECT_THAT(told, ElementsAre("a", "b", "a"));
}

TEST(Problems, of_each_kind_there_is_one_and_dismissing_takes_that_one) {
  MessageLog log;
  Problems problems(log);
  problems.set(ProblemKind::input, "a");
  problems.set(ProblemKind::shader, "b");
  problems.set(ProblemKind::shader, "c");
  problems.dismiss(ProblemKind::input);
  EXPECT_THAT(problems.all(), ElementsAre(std::pair(ProblemKind::shader, std::string("c"))));
}

}  // namespace
}  // namespace inkbench
