// SPDX-License-Identifier: MIT
// The command line of the settings: what a shell makes of it, read back, gives equal settings.
#include "app/workbench/render_command_text.h"

#include <array>
#include <cstdio>
#include <cstdlib>

#include "app/workbench/own_program.h"
#include "app/workbench/scene_base.h"
#include "pipeline/base/text.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// The words that a shell passes to the program.
std::vector<std::string> words_of(const std::string& command) {
  const TemporaryFolder folder;
  const auto script = folder.write(
      "script", "inkbench() { for word in \"$@\"; do printf '%s\\0' \"$word\"; done; }\n" + command + "\n");
  FILE* pipe = popen(("sh " + script.string()).c_str(), "r");
  std::string output;
  std::array<char, 4096> chunk{};
  while (const size_t count = fread(chunk.data(), 1, chunk.size(), pipe)) output.append(chunk.data(), count);
  EXPECT_EQ(pclose(pipe), 0);
  std::vector<std::string> words;
  for (size_t begin = 0; begin < output.size();) {
    words.emplace_back(output.c_str() + begin);
    begin += words.back().size() + 1;
  }
  return words;
}

/// What `inkbench render` would make of the words: the scene, then each assignment.
Settings settings_of(const std::vector<std::string>& words) {
  fs::path scene = default_scene();
  std::vector<std::string> assignments;
  for (size_t i = 1; i + 1 < words.size(); i += 2) {
    if (words[i] == "--scene") scene = words[i + 1];
    if (words[i] == "--set") assignments.push_back(words[i + 1]);
  }
  Settings settings = load_settings(scene);
  for (const std::string& assignment : assignments) apply_assignment(settings, assignment);
  return settings;
}

TEST(RenderCommand, of_the_papers_scene_names_no_parameter) {
  const RenderCommand command = render_command(paper_settings(), "");
  EXPECT_EQ(command.text, "inkbench render --buffers final --out out/render");
  EXPECT_THAT(command.assignments, IsEmpty());
}

TEST(RenderCommand, sets_only_what_differs_in_plain_words) {
  Settings settings = paper_settings();
  settings.combine.k_depth = 0.001F;
  settings.image.precision = Precision::unorm8;
  settings.camera.eye.x = 3.0F;
  EXPECT_EQ(render_command(settings, default_scene(), {BufferName::depth, BufferName::final}, "out/a b").text,
            "inkbench render --set image.precision=unorm8 --set camera.eye.x=3 --set combine.k_depth=0.001 "
            "--buffers depth,final --out 'out/a b'");
}

TEST(RenderCommand, comes_back_through_a_shell_for_every_parameter) {
  Settings settings = paper_settings();
  settings.models[0].mesh = "/a b/it's \"$HOME\" `x` \\ ü*.ply";
  settings.ramp.specular = {{}, "/ramps/[1], {2}.png"};
  settings.ramp.diffuse.stops[1] = {0.25F, {0.1F, 0.2F, 0.1F / 3.0F}, false};
  settings.ramp.enabled = false;
  settings.lights[0].type = LightType::point;
  settings.lights[0].direction = {-1, 0.5F, 0.25F};
  settings.models[1].shape = Shape::rounded_box;
  settings.models[1].material.colour = {0.1F / 3.0F, 1e-7F, 1};
  settings.mesh.faces = 1234;
  settings.image.width = 333;
  settings.combine.use_depth = false;
  const std::vector<std::string> words = words_of(render_command(settings, "").text);
  ASSERT_EQ(words.at(0), "render");
  EXPECT_EQ(text(settings_of(words)), text(settings));
}

TEST(RenderCommand, names_another_scene) {
  const TemporaryFolder folder;
  Settings settings = paper_settings();
  settings.models.erase(settings.models.begin());
  const fs::path scene = folder.write("it's mine.toml", settings_text(settings));
  settings.combine.k_normal = 0.5F;
  const RenderCommand command = render_command(settings, scene);
  EXPECT_EQ(command.scene, scene);
  EXPECT_EQ(text(settings_of(words_of(command.text))), text(settings));
}

TEST(RenderCommand, without_a_scene_of_these_models_is_an_error_that_helps) {
  Settings settings = paper_settings();
  settings.models.clear();
  EXPECT_THAT(error_of([&] { render_command(settings, default_scene()); }),
              HasSubstr("save the settings as a preset"));
}

/// The shell's search path while it lives.
class SearchPath {
 public:
  explicit SearchPath(const std::string& path) : before_(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  SearchPath(const SearchPath&) = delete;
  SearchPath& operator=(const SearchPath&) = delete;
  ~SearchPath() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

TEST(ProgramWord, is_the_name_alone_where_the_shell_would_find_this_very_program) {
  const TemporaryFolder ours, other;
  fs::create_symlink(own_program(), ours.path() / "inkbench");
  fs::create_symlink("/bin/true", other.path() / "inkbench");
  const std::string whole = shell_word(own_program().string());
  const std::string first = ours.path().string(), second = other.path().string();
  EXPECT_EQ((SearchPath("/nowhere:" + first + ":" + second), program_word()), "inkbench");
  EXPECT_EQ((SearchPath(second + ":" + first), program_word()), whole) << "it would find another one";
  EXPECT_EQ((SearchPath("/nowhere"), program_word()), whole);
}

TEST(AssignmentText, of_a_choice_has_no_quotes) {
  const Settings settings = paper_settings();
  const ConstParam choice = find_param(settings, "image.precision", "");
  EXPECT_EQ(assignment_text(*choice.field, choice.key, choice.value()), "image.precision=float");
}

TEST(ShellWord, leaves_plain_words_and_quotes_the_rest) {
  EXPECT_EQ(shell_word("out/a_b-1.png"), "out/a_b-1.png");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("~"), "'~'");
  EXPECT_EQ(shell_word("a'b"), "'a'\\''b'");
  const std::string all = "\t !\"#$&'()*;<>?[\\]^`{|}~\n\xc3\xa4";
  EXPECT_EQ(words_of("inkbench " + shell_word(all)), std::vector<std::string>{all});
}

}  // namespace
}  // namespace inkbench
