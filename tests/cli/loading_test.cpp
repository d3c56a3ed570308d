// SPDX-License-Identifier: MIT
// What is loaded when: OpenImageIO's 260 libraries only where an image is read or written.
#include "tests/cli/cli_test.h"
#include "tests/places.h"

namespace inkbench {
namespace {

using testing::HasSubstr;
using testing::Not;

class Loading : public CliTest {
 protected:
  /// The names of the libraries that a run loads, as the dynamic loader tells them.
  std::string loaded_by(const std::vector<std::string>& arguments) const {
    CommandOptions options;
    options.environment["LD_DEBUG"] = "files";
    options.environment["LD_DEBUG_OUTPUT"] = file("loaded").string();
    EXPECT_EQ(inkbench(arguments, options).status, 0);
    std::string told;
    for (const auto& [name, content] : folder_content(file(""))) {
      if (name.starts_with("loaded.")) told += content;
    }
    EXPECT_NE(told.find("libstdc++"), std::string::npos) << "the loader did not tell";
    return told;
  }
};

TEST_F(Loading, commands_without_images_load_no_image_library) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--version"}, {"--help"}, {"params"}, {"decimate", "--help"}}) {
    EXPECT_EQ(loaded_by(arguments).find("libOpenImageIO"), std::string::npos) << arguments.front();
  }
}

TEST_F(Loading, an_image_that_openimageio_writes_loads_it) {
  const std::string scene = write("scene.toml", small_scene()).string();
  const std::string loaded = loaded_by({"render", "--scene", scene, "--format", "exr", "--out", "out"});
  EXPECT_NE(loaded.find("libOpenImageIO"), std::string::npos);
}

TEST_F(Loading, a_missing_image_module_is_an_error_that_names_it) {
  fs::copy_file(inkbench_program(), file("alone"));
  const CommandResult result =
      run_command({file("alone").string(), "render", "--scene", write("scene.toml", small_scene()).string(),
                   "--format", "exr", "--out", "out"},
                  {.working_folder = file("")});
  EXPECT_TRUE(is_work_error(result, {"inkbench_image_codecs.so", file("").parent_path().string(),
                                     "keep this file beside the executable"}));
}

}  // namespace
}  // namespace inkbench
