// SPDX-License-Identifier: MIT
// Editing shaders while the program runs: what depends on the edit runs again; a broken edit keeps the last
// good program.
#include <gtest/gtest.h>

#include <set>

#include "pipeline/pipeline.h"
#include "tests/gl/scenes.h"
#include "tests/gl/shader_folder.h"

namespace inkbench {
namespace {

using Names = std::set<std::string>;

class HotReload : public testing::Test {
 protected:
  HotReload() : before_(pipeline_.at(small_scene()).raw(BufferName::final)) {}

  /// The final image, and the passes that it took since the last one.
  Image draw() {
    const auto counts = pipeline_.counts();
    Image image = pipeline_.at(small_scene()).raw(BufferName::final);
    ran_.clear();
    for (const auto& [name, count] : pipeline_.counts()) {
      if (count.runs != counts.at(name).runs) ran_.insert(name);
    }
    return image;
  }

  ShaderFolder folder_;  // first: the pipeline reads its shaders there
  Pipeline pipeline_;
  Image before_;
  Names ran_;
};

TEST_F(HotReload, without_edits_runs_nothing) {
  pipeline_.reload_changed_shaders();
  EXPECT_TRUE(is_near(draw(), before_, 0.0));
  EXPECT_EQ(ran_, Names{});
}

TEST_F(HotReload, edited_pass_runs_with_what_follows_it) {
  folder_.edit("combine.frag", "combine.threshold ? 0.0", "combine.threshold ? 1.0");
  pipeline_.reload_changed_shaders();
  const Image image = draw();
  EXPECT_EQ(ran_, (Names{"combine", "ink"}));
  EXPECT_FALSE(image == before_);
  for (const float value : image.samples) ASSERT_EQ(value, 0.0F) << "every pixel is inked";
}

TEST_F(HotReload, edited_shading_runs_no_edge_pass) {
  folder_.edit("shade.frag", "colour = vec4(sum, 1.0)", "colour = vec4(sum * 0.5, 1.0)");
  pipeline_.reload_changed_shaders();
  EXPECT_FALSE(draw() == before_);
  EXPECT_EQ(ran_, (Names{"shade", "ink"}));
}

TEST_F(HotReload, touched_file_with_the_same_text_runs_nothing) {
  folder_.write("combine.frag", folder_.read("combine.frag"));
  pipeline_.reload_changed_shaders();
  EXPECT_TRUE(is_near(draw(), before_, 0.0));
  EXPECT_EQ(ran_, Names{});
}

TEST_F(HotReload, broken_edit_keeps_program_and_image_and_is_told_once) {
  const std::string good = folder_.read("combine.frag");
  folder_.edit("combine.frag", "float sum = p.x + p.y;", "float sum = p.x + q.y;");
  const std::string error = input_error_of([&] { pipeline_.reload_changed_shaders(); });
  EXPECT_NE(error.find("shaders/combine.frag:13"), std::string::npos) << error;
  EXPECT_NO_THROW(pipeline_.reload_changed_shaders());
  EXPECT_TRUE(is_near(draw(), before_, 0.0));
  EXPECT_EQ(ran_, Names{});
  Settings other = small_scene();
  other.combine.threshold = 0.1F;
  EXPECT_NO_THROW(pipeline_.at(other).raw(BufferName::final)) << "the last good program still draws";

  folder_.write("combine.frag", good);
  EXPECT_NO_THROW(pipeline_.reload_changed_shaders());
  EXPECT_TRUE(is_near(draw(), before_, 0.0));
}

TEST_F(HotReload, mended_edit_takes_effect) {
  folder_.edit("combine.frag", "combine.threshold ? 0.0", "combine.threshold ? nonsense");
  input_error_of([&] { pipeline_.reload_changed_shaders(); });
  folder_.edit("combine.frag", "nonsense", "1.0");
  pipeline_.reload_changed_shaders();
  EXPECT_FALSE(draw() == before_);
  EXPECT_EQ(ran_, (Names{"combine", "ink"}));
}

TEST_F(HotReload, problem_stays_until_every_program_compiles) {
  EXPECT_EQ(pipeline_.shader_problem(), "");
  const std::string combine = folder_.read("combine.frag");
  const std::string ink = folder_.read("ink.frag");
  folder_.write("combine.frag", combine + "nonsense\n");
  input_error_of([&] { pipeline_.reload_changed_shaders(); });
  folder_.write("ink.frag", ink + "nonsense\n");
  input_error_of([&] { pipeline_.reload_changed_shaders(); });
  folder_.write("combine.frag", combine);
  EXPECT_TRUE(pipeline_.reload_changed_shaders());
  EXPECT_NE(pipeline_.shader_problem().find("shaders/ink.frag"), std::string::npos)
      << pipeline_.shader_problem();
  folder_.write("ink.frag", ink);
  EXPECT_TRUE(pipeline_.reload_changed_shaders());
  EXPECT_EQ(pipeline_.shader_problem(), "");
}

TEST_F(HotReload, deleted_shader_keeps_the_last_good_program) {
  fs::rename(project_file("shaders/combine.frag"), project_file("shaders/elsewhere.frag"));
  const std::string error = input_error_of([&] { pipeline_.reload_changed_shaders(); });
  EXPECT_NE(error.find("shaders/combine.frag"), std::string::npos) << error;
  EXPECT_TRUE(is_near(draw(), before_, 0.0));
}

TEST_F(HotReload, edit_of_an_included_file_counts) {
  folder_.edit("lib/draw_block.glsl", "// What one", "// An edit. What one");
  pipeline_.reload_changed_shaders();
  EXPECT_TRUE(is_near(draw(), before_, 0.0));
  EXPECT_TRUE(ran_.contains("gbuffer"));
}

TEST_F(HotReload, broken_included_file_is_named) {
  folder_.edit("lib/draw_block.glsl", "float far;", "flaot far;");
  const std::string error = input_error_of([&] { pipeline_.reload_changed_shaders(); });
  EXPECT_NE(error.find("shaders/lib/draw_block.glsl:8"), std::string::npos) << error;
  EXPECT_TRUE(is_near(draw(), before_, 0.0));
}

TEST_F(HotReload, uniform_that_nobody_supplies_keeps_the_last_good_program) {
  folder_.edit("ink.frag", "void main() {", "uniform float strength;\nvoid main() {");
  folder_.edit("ink.frag", "is_line(ink", "is_line(strength * ink");
  const std::string error = input_error_of([&] { pipeline_.reload_changed_shaders(); });
  EXPECT_NE(error.find("'strength'"), std::string::npos) << error;
  EXPECT_TRUE(is_near(draw(), before_, 0.0));
}

TEST_F(HotReload, file_included_by_a_broken_edit_is_watched_too) {
  folder_.write("lib/fresh.glsl", "float twice(float x) { return 2.0 * y; }\n");
  folder_.edit("combine.frag", "#include \"generated/combine.glsl\"",
               "#include \"generated/combine.glsl\"\n#include \"lib/fresh.glsl\"");
  folder_.edit("combine.frag", "combine.threshold ? 0.0", "combine.threshold ? twice(0.5)");
  const std::string error = input_error_of([&] { pipeline_.reload_changed_shaders(); });
  EXPECT_NE(error.find("shaders/lib/fresh.glsl:1"), std::string::npos) << error;
  folder_.write("lib/fresh.glsl", "float twice(float x) { return 2.0 * x; }\n");
  pipeline_.reload_changed_shaders();
  EXPECT_FALSE(draw() == before_);
  EXPECT_EQ(ran_, (Names{"combine", "ink"}));
}

}  // namespace
}  // namespace inkbench
