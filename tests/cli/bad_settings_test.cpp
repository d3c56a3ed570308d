// SPDX-License-Identifier: MIT
// Scene files, `--set` and `--size` that are wrong: one message with the place, the value and what would be
// right.
#include "tests/cli/cli_test.h"

namespace inkbench {
namespace {

class BadSettings : public CliTest {
 protected:
  BadSettings() { write("scene.toml", small_scene()); }

  void expect_scene_refused(const std::string& content, const std::vector<std::string>& words) const {
    write("bad.toml", content);
    EXPECT_TRUE(is_input_error(inkbench({"render", "--scene", "bad.toml", "--out", "out"}), words))
        << content;
    EXPECT_FALSE(fs::exists(file("out")));
  }
  void expect_set_refused(const std::string& assignment, const std::vector<std::string>& words) const {
    EXPECT_TRUE(is_input_error(
        inkbench({"render", "--scene", "scene.toml", "--out", "out", "--set", assignment}), words));
    EXPECT_TRUE(!fs::exists(file("out")) || fs::is_empty(file("out")));
  }
  void expect_size_refused(const std::string& size, const std::vector<std::string>& words) const {
    EXPECT_TRUE(
        is_input_error(inkbench({"render", "--scene", "scene.toml", "--out", "out", "--size", size}), words));
    EXPECT_TRUE(!fs::exists(file("out")) || fs::is_empty(file("out")));
  }
};

TEST_F(BadSettings, missing_scene_is_named) {
  EXPECT_TRUE(is_input_error(inkbench({"render", "--scene", "none.toml", "--out", "out"}),
                             {"none.toml", "no such file"}));
}

TEST_F(BadSettings, unknown_key_suggests_the_nearest) {
  expect_scene_refused("[combine]\nk_depht = 0.1\n",
                       {"bad.toml:2", "combine.k_depht", "did you mean 'combine.k_depth'?"});
  expect_scene_refused("[combin]\nk_depth = 0.1\n", {"bad.toml:2", "combin.k_depth", "'combine.k_depth'"});
  expect_set_refused("combine.kdepth=0.1", {"--set", "combine.kdepth", "did you mean 'combine.k_depth'?"});
  expect_set_refused("model.boxx.size=1", {"model.boxx.size", "'model.box.size'"});
}

TEST_F(BadSettings, a_table_of_a_model_that_is_not_there_shows_how_one_is_written) {
  expect_scene_refused("[model.wheel]\nshape = \"box\"\n",
                       {"bad.toml:2", "no model 'wheel'", "[[model]] and name = \"wheel\""});
}

TEST_F(BadSettings, an_option_with_an_empty_text_is_refused_by_its_name) {
  for (const std::string option : {"--mesh", "--scene", "--from", "--out", "--size"}) {
    EXPECT_TRUE(is_input_error(inkbench({"render", "--out", "out", option, ""}), {option, "empty text"}));
  }
  EXPECT_TRUE(
      is_input_error(inkbench({"decimate", "", "--faces", "3", "--out", "out"}), {"MESH", "empty text"}));
  EXPECT_FALSE(fs::exists(file("out")));
}

TEST_F(BadSettings, wrong_type_says_which_is_right) {
  expect_scene_refused("[combine]\nk_depth = \"much\"\n", {"bad.toml:2", "combine.k_depth", "number"});
  expect_scene_refused("[ramp]\nenabled = 3\n", {"bad.toml:2", "ramp.enabled", "true", "false"});
  expect_scene_refused("[camera]\neye = [1, 2]\n", {"bad.toml:2", "camera.eye", "three"});
  expect_scene_refused("combine = 3\n", {"bad.toml:1", "combine"});
  expect_set_refused("camera.fov=wide", {"camera.fov", "number"});
  expect_set_refused("image.width=10.5", {"image.width", "whole"});
  expect_set_refused("ink.colour=#12345", {"ink.colour"});
}

TEST_F(BadSettings, value_out_of_range_says_the_range) {
  expect_scene_refused("[camera]\n\nfov = 171\n", {"bad.toml:3", "camera.fov = 171", "170"});
  expect_set_refused("combine.k_depth=0", {"combine.k_depth = 0", "1e-06", "1"});
  expect_set_refused("combine.k_depth=nan", {"combine.k_depth"});
  expect_set_refused("camera.eye.x=1e9", {"camera.eye"});
  expect_set_refused("image.precision=double", {"image.precision", "double", "float, unorm8"});
}

TEST_F(BadSettings, duplicate_key_is_an_error) {
  expect_scene_refused("[combine]\nk_depth = 0.1\nk_depth = 0.2\n", {"bad.toml:3", "k_depth"});
  expect_scene_refused("[combine]\nk_depth = 0.1\n[combine]\nk_normal = 0.2\n", {"bad.toml:3", "combine"});
  expect_scene_refused("[[model]]\nname = \"a\"\nshape = \"box\"\n[[model]]\nname = \"a\"\n",
                       {"bad.toml:4", "'a'"});
}

TEST_F(BadSettings, broken_toml_says_the_line) {
  expect_scene_refused("[camera]\nfov = 40\neye = [1, 2\n[scene]\n", {"bad.toml:"});
  expect_scene_refused("[camera\n", {"bad.toml:1"});
  expect_scene_refused("\xff\xfe\x00 junk", {"bad.toml:1"});
}

TEST_F(BadSettings, model_without_a_name_is_refused) {
  expect_scene_refused("[[model]]\nshape = \"box\"\n", {"bad.toml:1", "model", "name"});
  expect_scene_refused("[[light]]\nname = \"a.b\"\n", {"bad.toml:2", "a.b"});
}

TEST_F(BadSettings, base_that_leads_in_a_circle_is_refused) {
  expect_scene_refused("base = \"bad.toml\"\n", {"bad.toml:1", "circle"});
  write("other.toml", "base = \"bad.toml\"\n");
  expect_scene_refused("base = \"other.toml\"\n", {"bad.toml", "other.toml", "circle"});
}

TEST_F(BadSettings, missing_base_is_named_with_the_line_that_names_it) {
  expect_scene_refused("title = \"x\"\nbase = \"lost.toml\"\n", {"bad.toml:2", "lost.toml", "no such file"});
}

TEST_F(BadSettings, missing_or_broken_ramp_image_is_named) {
  write("broken.png", "not a picture");
  expect_set_refused("ramp.diffuse=lost.png", {"lost.png"});
  expect_set_refused("ramp.diffuse=broken.png", {"broken.png"});
  write("study.toml", "scene = \"scene.toml\"\n[set]\nramp.specular = \"lost.png\"\n");
  EXPECT_TRUE(
      is_input_error(inkbench({"study", "study.toml", "--out", "out"}), {"ramp.specular", "lost.png"}));
}

TEST_F(BadSettings, camera_that_sees_nothing_is_refused) {
  expect_set_refused("camera.eye=[0, 1, 0]", {"camera.eye", "camera.target"});
  expect_set_refused("camera.up=[0, 0, 1]", {"camera.up"});
  expect_set_refused("camera.near=30", {"camera.near", "camera.far"});
}

TEST_F(BadSettings, assignment_without_a_value_shows_an_example) {
  expect_set_refused("combine.k_depth", {"KEY=VALUE", "--set combine.k_depth="});
  expect_set_refused("=3", {"KEY=VALUE"});
  expect_set_refused("combine.k_depth=", {"combine.k_depth"});
}

TEST_F(BadSettings, size_in_another_form_shows_an_example) {
  for (const std::string size : {"big", "100", "100x", "x100", "100x100x100", "100 x 100", "1e3x10"}) {
    expect_size_refused(size, {"--size " + size, "WIDTHxHEIGHT"});
  }
}

TEST_F(BadSettings, size_out_of_range_is_refused) {
  expect_size_refused("0x100", {"image.width = 0"});
  expect_size_refused("100x-5", {"image.height = -5"});
  expect_size_refused("99999x1", {"image.width = 99999", "32768"});
}

TEST_F(BadSettings, size_beyond_the_renderers_limit_names_the_limit) {
  expect_size_refused("32768x1", {"32768 x 1", "px"});
  expect_size_refused("20000x32000", {"20000 x 32000", "px"});
}

TEST_F(BadSettings, renderer_that_does_not_exist_names_the_choices) {
  CommandOptions options;
  options.environment["INKBENCH_RENDERER"] = "vulkan";
  EXPECT_TRUE(
      is_input_error(inkbench({"info"}, options), {"INKBENCH_RENDERER", "vulkan", "auto, gpu, software"}));
}

TEST_F(BadSettings, missing_egl_names_the_packages) {
  CommandOptions no_driver;
  no_driver.environment["__EGL_VENDOR_LIBRARY_DIRS"] = "/nonexistent";
  write("fake/libEGL.so.1", "no library");
  CommandOptions no_library;
  no_library.environment["LD_LIBRARY_PATH"] = file("fake");
  for (const CommandOptions& options : {no_driver, no_library}) {
    const CommandResult result = inkbench({"render", "--scene", "scene.toml", "--out", "out"}, options);
    EXPECT_TRUE(is_work_error(result, {"EGL", "install", "libegl1", "libgl1-mesa-dri"}));
    EXPECT_FALSE(fs::exists(file("out")));
  }
}

}  // namespace
}  // namespace inkbench
