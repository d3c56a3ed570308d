// SPDX-License-Identifier: MIT
// Shaders that do not compile, include wrongly or read what nobody supplies: an input error that names file
// and line.
#include <gtest/gtest.h>

#include "pipeline/pipeline.h"
#include "tests/gl/shader_folder.h"

namespace inkbench {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class Shaders : public testing::Test {
 protected:
  /// The error of compiling test.frag with this text.
  std::string error_of(const std::string& fragment, const ProgramInputs& inputs = {}) {
    folder_.write("test.frag", fragment);
    return input_error_of([&] { Program("full_screen.vert", "test.frag", inputs, generated_sources()); });
  }
  ShaderFolder folder_;
};

TEST_F(Shaders, syntax_error_names_file_and_line) {
  const std::string error =
      error_of("#version 450 core\nout vec4 colour;\nvoid main() {\n  colour = vec4(1.0)\n}\n");
  EXPECT_TRUE(contains(error, "shaders/test.frag:5") || contains(error, "shaders/test.frag:4")) << error;
}

TEST_F(Shaders, error_in_an_included_file_names_that_file) {
  folder_.write("lib/broken.glsl", "float fine() { return 1.0; }\nfloat broken() { return nonsense; }\n");
  const std::string error = error_of(
      "#version 450 core\n#include \"lib/broken.glsl\"\nout vec4 colour;\nvoid main() { colour = "
      "vec4(broken()); }\n");
  EXPECT_TRUE(contains(error, "shaders/lib/broken.glsl:2")) << error;
}

TEST_F(Shaders, lines_after_an_include_keep_their_numbers) {
  folder_.write("lib/long.glsl", "\n\n\n\n\nfloat one() { return 1.0; }\n");
  const std::string error = error_of(
      "#version 450 core\n#include \"lib/long.glsl\"\nout vec4 colour;\nvoid main() { colour = nonsense; "
      "}\n");
  EXPECT_TRUE(contains(error, "shaders/test.frag:4")) << error;
}

TEST_F(Shaders, missing_include_names_the_line_that_includes) {
  const std::string error = error_of("#version 450 core\n\n#include \"lib/nowhere.glsl\"\nvoid main() {}\n");
  EXPECT_TRUE(contains(error, "shaders/test.frag:3") && contains(error, "lib/nowhere.glsl")) << error;
}

TEST_F(Shaders, include_without_a_name_names_its_line) {
  const std::string error = error_of("#version 450 core\n#include nothing\nvoid main() {}\n");
  EXPECT_TRUE(contains(error, "shaders/test.frag:2")) << error;
}

TEST_F(Shaders, circular_include_names_the_line_that_closes_the_circle) {
  folder_.write("lib/a.glsl", "#include \"lib/b.glsl\"\n");
  folder_.write("lib/b.glsl", "// b\n#include \"lib/a.glsl\"\n");
  const std::string error = error_of("#version 450 core\n#include \"lib/a.glsl\"\nvoid main() {}\n");
  EXPECT_TRUE(contains(error, "shaders/lib/b.glsl:2") && contains(error, "lib/a.glsl")) << error;
}

TEST_F(Shaders, file_included_twice_is_there_once) {
  folder_.write("lib/one.glsl", "float one() { return 1.0; }\n");
  folder_.write("test.frag",
                "#version 450 core\n#include \"lib/one.glsl\"\n#include \"lib/one.glsl\"\nout vec4 "
                "colour;\nvoid main() { colour = vec4(one()); }\n");
  EXPECT_NO_THROW(Program("full_screen.vert", "test.frag", {}, generated_sources()));
}

TEST_F(Shaders, missing_shader_is_named) {
  const std::string error = input_error_of([] { Program("full_screen.vert", "nowhere.frag", {}, {}); });
  EXPECT_TRUE(contains(error, "shaders/nowhere.frag")) << error;
}

TEST_F(Shaders, uniform_that_nobody_supplies_is_an_error) {
  const std::string error = error_of(
      "#version 450 core\nuniform float strength;\nout vec4 colour;\nvoid main() { colour = vec4(strength); "
      "}\n");
  EXPECT_TRUE(contains(error, "shaders/test.frag:2") && contains(error, "'strength'")) << error;
}

TEST_F(Shaders, uniform_of_a_vertex_shader_or_an_included_file_names_that_file) {
  folder_.write(
      "test.vert",
      "#version 450 core\n\nuniform float strength;\nvoid main() { gl_Position = vec4(strength); }\n");
  folder_.write("test.frag", "#version 450 core\nout vec4 colour;\nvoid main() { colour = vec4(1.0); }\n");
  const std::string in_vertex = input_error_of([] { Program("test.vert", "test.frag", {}, {}); });
  EXPECT_TRUE(contains(in_vertex, "shaders/test.vert:3")) << in_vertex;
  folder_.write("lib/strong.glsl", "\n// strengths\n\nuniform float strengths[3];\n");
  const std::string in_included = error_of(
      "#version 450 core\n#include \"lib/strong.glsl\"\nout vec4 colour;\nvoid main() { colour = "
      "vec4(strengths[int(gl_FragCoord.x)]); }\n");
  EXPECT_TRUE(contains(in_included, "shaders/lib/strong.glsl:4")) << in_included;
}

TEST_F(Shaders, sampler_that_nobody_supplies_is_an_error) {
  const std::string error = error_of(
      "#version 450 core\nuniform sampler2D depth_mpa;\nout vec4 colour;\nvoid main() { colour = "
      "texelFetch(depth_mpa, ivec2(0), 0); }\n",
      {.samplers = {"depth_map"}});
  EXPECT_TRUE(contains(error, "'depth_mpa'")) << error;
}

TEST_F(Shaders, uniform_block_that_nobody_supplies_is_an_error) {
  const std::string error = error_of(
      "#version 450 core\nlayout(std140) uniform wrong_block { float gain; } wrong;\nout vec4 colour;\nvoid "
      "main() { colour = vec4(wrong.gain); }\n",
      {.uniform_blocks = {{"right_block", 16}}});
  EXPECT_TRUE(contains(error, "'wrong_block'")) << error;
}

TEST_F(Shaders, block_with_another_member_is_an_error_that_names_it_and_both_sizes) {
  folder_.edit("picture.frag", "  float gain;", "  float gain;\n  vec4 tint;");
  const std::string error = input_error_of([] { Pipeline(); });
  EXPECT_TRUE(contains(error, "shaders/picture.frag:7: 'picture_block' has 48 bytes, but 16 are supplied"))
      << error;
}

TEST_F(Shaders, block_whose_members_stand_in_an_order_of_another_size_is_an_error) {
  folder_.edit("shade.frag", "  int use_ramps;\n", "");
  folder_.edit("shade.frag", "  vec3 eye; ", "  int use_ramps;\n  vec3 eye; ");
  folder_.edit("shade.frag", "  float far; ", "  ");
  folder_.edit("shade.frag", "  int light_count;\n", "  int light_count;\n  float far;\n");
  const std::string error = input_error_of([] { Pipeline(); });
  EXPECT_TRUE(contains(error, "shaders/shade.frag:11: 'view_block' has 176 bytes, but 160 are")) << error;
}

TEST_F(Shaders, block_in_an_included_file_is_named_there) {
  folder_.edit("lib/draw_block.glsl", "  float far; ", "  mat4 spare;\n  float far; ");
  const std::string error = input_error_of([] { Pipeline(); });
  EXPECT_TRUE(contains(error, "shaders/lib/draw_block.glsl:4: 'draw_block' has 240 bytes, but 160 are"))
      << error;
}

TEST_F(Shaders, list_of_another_length_is_an_error) {
  folder_.edit("shade.frag", "Light lights[max_lights]", "Light lights[max_lights + 1]");
  const std::string error = input_error_of([] { Pipeline(); });
  EXPECT_TRUE(contains(error, "shaders/shade.frag:28: 'light_list'")) << error;
}

TEST_F(Shaders, parameter_without_description_is_no_member) {
  const std::string error = error_of(
      "#version 450 core\n#include \"generated/combine.glsl\"\nout vec4 colour;\nvoid main() {\n  colour = "
      "vec4(combine.k_dpeth);\n}\n",
      {.uniform_blocks = {block_of(CombineParams::description())}});
  EXPECT_TRUE(contains(error, "shaders/test.frag:5") && contains(error, "k_dpeth")) << error;
}

TEST_F(Shaders, a_failed_program_leaves_no_error_for_the_next_pass) {
  error_of("#version 450 core\nnonsense\n");
  EXPECT_NO_THROW(Pipeline());
}

}  // namespace
}  // namespace inkbench
