// SPDX-License-Identifier: MIT
// Help, version, wrong usage, and the commands that only print: params and info.
#include <nlohmann/json.hpp>

#include <set>
#include <sstream>

#include "pipeline/base/text.h"
#include "studies/measures/measures.h"
#include "tests/cli/cli_test.h"
#include "tests/places.h"

namespace inkbench {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Usage : public CliTest {};

/// The keys in the order of the text table's "  key = default" lines.
std::vector<std::string> keys_of_text(const std::string& text) {
  std::vector<std::string> keys;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const size_t equals = line.find(" = ");
    if (line.starts_with("  ") && line[2] != ' ' && equals != std::string::npos)
      keys.push_back(line.substr(2, equals - 2));
  }
  return keys;
}

TEST_F(Usage, help_of_every_command_has_an_example) {
  for (const std::vector<std::string>& command : {std::vector<std::string>{},
                                                  {"render"},
                                                  {"study"},
                                                  {"score"},
                                                  {"measure"},
                                                  {"decimate"},
                                                  {"params"},
                                                  {"info"}}) {
    std::vector<std::string> arguments = command;
    arguments.emplace_back("--help");
    const CommandResult result = inkbench(arguments);
    ASSERT_TRUE(succeeds(result));
    const size_t example = result.out.find("Example");
    ASSERT_NE(example, std::string::npos) << result.out;
    EXPECT_THAT(result.out.substr(example), HasSubstr("\n  inkbench " + (command.empty() ? "" : command[0])))
        << result.out;
    EXPECT_THAT(result.err, IsEmpty());
  }
}

TEST_F(Usage, short_help_is_help) {
  EXPECT_EQ(inkbench({"render", "-h"}).out, inkbench({"render", "--help"}).out);
}

TEST_F(Usage, version_is_one_line) {
  const CommandResult result = inkbench({"--version"});
  ASSERT_TRUE(succeeds(result));
  EXPECT_EQ(result.out, "inkbench " INKBENCH_VERSION "\n");
}

TEST_F(Usage, no_command_names_the_commands) {
  EXPECT_TRUE(is_input_error(
      inkbench({}), {"render", "study", "score", "measure", "decimate", "params", "info", "--help"}));
}

TEST_F(Usage, unknown_command_is_named) {
  EXPECT_TRUE(is_input_error(inkbench({"paint"}), {"paint", "render", "study"}));
}

TEST_F(Usage, unknown_option_is_named) {
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"render", "--out", "out"}, {"study", "list"}, {"params"}, {"info"}}) {
    std::vector<std::string> arguments = command;
    arguments.emplace_back("--colour");
    EXPECT_TRUE(is_input_error(inkbench(arguments), {"--colour", "--help"})) << command[0];
  }
}

TEST_F(Usage, missing_required_option_is_named) {
  EXPECT_TRUE(is_input_error(inkbench({"render"}), {"--out"}));
  EXPECT_TRUE(is_input_error(inkbench({"study"}), {"SPEC"}));
}

TEST_F(Usage, option_without_its_value_is_named) {
  EXPECT_TRUE(is_input_error(inkbench({"render", "--out"}), {"--out"}));
  EXPECT_TRUE(is_input_error(inkbench({"render", "--out", "a", "--set"}), {"--set"}));
}

TEST_F(Usage, unknown_format_names_the_known_ones) {
  EXPECT_TRUE(is_input_error(inkbench({"params", "--format", "html"}), {"html", "text", "markdown", "json"}));
  EXPECT_TRUE(is_input_error(inkbench({"render", "--format", "gif", "--out", "a"}), {"gif", "png", "exr"}));
  EXPECT_FALSE(fs::exists(file("a")));
}

TEST_F(Usage, scene_and_from_exclude_each_other) {
  EXPECT_TRUE(is_input_error(inkbench({"render", "--scene", "a.toml", "--from", "b.png", "--out", "c"}),
                             {"--from", "--scene"}));
}

TEST_F(Usage, params_has_the_same_keys_in_each_format) {
  const CommandResult text = inkbench({"params"});
  const CommandResult markdown = inkbench({"params", "--format", "markdown"});
  const CommandResult json = inkbench({"params", "--format", "json"});
  ASSERT_TRUE(succeeds(text) && succeeds(markdown) && succeeds(json));
  EXPECT_EQ(text.out, inkbench({"params", "--format", "text"}).out);

  const std::vector<std::string> keys = keys_of_text(text.out);
  EXPECT_THAT(keys, testing::IsSupersetOf({"combine.k_depth", "combine.k_normal", "combine.threshold",
                                           "image.precision", "camera.eye", "ramp.diffuse",
                                           "light.<name>.direction", "model.<name>.mesh",
                                           "display.depth_edges_gain", "display.normal_edges_gain"}));
  std::vector<std::string> json_keys;
  for (const nlohmann::json& entry : nlohmann::json::parse(json.out)) {
    json_keys.push_back(entry.at("key"));
    EXPECT_THAT(entry.at("help").get<std::string>(), Not(IsEmpty())) << entry;
    EXPECT_TRUE(entry.contains("default") && entry.contains("type") && entry.contains("unit")) << entry;
    EXPECT_THAT(markdown.out, HasSubstr("| `" + json_keys.back() + "` |"));
  }
  EXPECT_EQ(json_keys, keys);
  EXPECT_EQ(std::set(keys.begin(), keys.end()).size(), keys.size());
}

TEST_F(Usage, params_defaults_are_the_papers) {
  const CommandResult text = inkbench({"params"});
  EXPECT_THAT(text.out, HasSubstr("combine.k_depth = 0.003"));
  EXPECT_THAT(text.out, HasSubstr("combine.k_normal = 0.0125"));
  EXPECT_THAT(text.out, HasSubstr("combine.threshold = 0.75"));
  EXPECT_THAT(text.out, HasSubstr("display.depth_edges_gain = 128"));
  EXPECT_THAT(text.out, HasSubstr("display.normal_edges_gain = 16"));
  EXPECT_THAT(text.out, HasSubstr("image.precision = \"float\""));
}

TEST_F(Usage, tables_in_the_docs_are_the_programs) {
  for (const auto& [name, command] :
       {std::pair{"parameters.md", std::vector<std::string>{"params", "--format", "markdown"}},
        {"measures.md", {"measure", "--list", "markdown"}},
        {"architecture.md", {"passes", "--format", "markdown"}}}) {
    const std::string content = content_of(fs::path(source_folder()) / "docs" / name);
    const std::string marker = "<!-- generated: inkbench " + join(command, " ") + " -->\n";
    const size_t start = content.find(marker);
    ASSERT_NE(start, std::string::npos) << name << " has no line " << marker;
    EXPECT_EQ(content.substr(start + marker.size()), inkbench(command).out)
        << "scripts/update_docs.sh writes it anew";
  }
}

TEST_F(Usage, every_measure_is_defined_in_the_docs) {
  std::string page = content_of(fs::path(source_folder()) / "docs/measures.md");
  page.resize(page.find("## All measures"));
  for (const Measure& measure : measure_table()) {
    const std::string key = measure.line_class ? "recall_CLASS" : measure.key;
    EXPECT_THAT(page, HasSubstr("`" + key + "`"));
  }
}

TEST_F(Usage, params_needs_no_gl) {
  CommandOptions no_egl;
  no_egl.environment["__EGL_VENDOR_LIBRARY_DIRS"] = "/nonexistent";
  EXPECT_TRUE(succeeds(inkbench({"params"}, no_egl)));
}

TEST_F(Usage, info_names_renderer_versions_and_data) {
  const CommandResult result = inkbench({"info"});
  ASSERT_TRUE(succeeds(result));
  for (const char* word : {INKBENCH_VERSION, "renderer", "OpenGL", "4.", "EGL", "px", "bunny.obj"}) {
    EXPECT_THAT(result.out, HasSubstr(word));
  }
  EXPECT_THAT(result.out, HasSubstr(source_folder()));
}

TEST_F(Usage, info_names_where_a_persons_files_are_kept) {
  CommandOptions options;
  options.environment = {{"XDG_CONFIG_HOME", "/c"}, {"XDG_DATA_HOME", "/d"}, {"INKBENCH_CACHE", "/e"}};
  const CommandResult result = inkbench({"info"}, options);
  EXPECT_THAT(result.out,
              HasSubstr("\npresets     /c/inkbench\nstudies     /d/inkbench/studies\ncache       /e\n"));
}

TEST_F(Usage, info_says_where_the_rabbit_was_not_found) {
  CommandOptions options;
  options.environment["INKBENCH_RABBIT"] = "/nonexistent/rabbit.obj";
  const CommandResult result = inkbench({"info"}, options);
  EXPECT_TRUE(succeeds(result));
  EXPECT_THAT(result.out, HasSubstr("not found: INKBENCH_RABBIT: no such file: /nonexistent/rabbit.obj"));
}

}  // namespace
}  // namespace inkbench
