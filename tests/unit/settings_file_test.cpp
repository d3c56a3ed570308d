// SPDX-License-Identifier: MIT
// Scene files: what they say is what the settings are; what they cannot say is an error with file and line.
#include "pipeline/settings/settings_file.h"

#include <gmock/gmock.h>

#include <random>

#include "pipeline/base/files.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Settings parsed_settings(const std::string& text) {
  return parse_settings(text, "a.toml", "/scenes");
}

std::string settings_error(const std::string& text) {
  return error_of([&] { parsed_settings(text); });
}

void expect_equal(const Settings& a, const Settings& b) {
  Settings left = a;
  Settings right = b;
  const std::vector<Param> left_params = list_params(left);
  const std::vector<Param> right_params = list_params(right);
  ASSERT_EQ(left_params.size(), right_params.size());
  for (size_t i = 0; i < left_params.size(); ++i) {
    EXPECT_EQ(left_params[i].key, right_params[i].key);
    EXPECT_EQ(left_params[i].value(), right_params[i].value()) << left_params[i].key;
  }
}

class RandomSettings {
 public:
  explicit RandomSettings(unsigned seed) : random_(seed) {}

  Settings make() {
    Settings settings;
    const int models = count(4);
    const int lights = count(3);
    for (int i = 0; i < models; ++i) settings.models.emplace_back().name = "m-" + std::to_string(i);
    for (int i = 0; i < lights; ++i) settings.lights.emplace_back().name = "L_" + std::to_string(i);
    for (const Param& param : list_params(settings)) param.set(value(*param.field), "");
    return settings;
  }

 private:
  int count(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit + 1)); }
  float number(const Limits& limits) {
    const double t = static_cast<double>(random_()) / 4294967295.0;
    return std::clamp(static_cast<float>(limits.low + t * (limits.high - limits.low)),
                      static_cast<float>(limits.low), static_cast<float>(limits.high));
  }
  glm::vec3 vector(const Limits& limits) { return {number(limits), number(limits), number(limits)}; }
  std::string path() {
    const std::vector<std::string> names{"/a.obj", "/with \"quotes\"/b", "/caf\xc3\xa9/\xe5\x85\x94",
                                         "/line\nbreak\\", "/tab\t\x7f'"};
    return names[random_() % names.size()];
  }
  Ramp ramp() {
    if (count(3) == 0) return {{}, path()};
    Ramp ramp;
    float position = 0.0F;
    for (int i = 0; i <= count(5); ++i) {
      ramp.stops.push_back({position, vector({0, 1}), count(1) == 0});
      position = number({position, 1});
    }
    return ramp;
  }
  Value value(const Field& field) {
    switch (field.type) {
      case FieldType::boolean:
        return count(1) == 1;
      case FieldType::integer:
        return static_cast<int>(number(field.limits));
      case FieldType::real:
        return number(field.limits);
      case FieldType::vector:
      case FieldType::colour:
        return vector(field.limits);
      case FieldType::choice:
        return std::string(field.choices[random_() % field.choices.size()]);
      case FieldType::text:
        return path();
      case FieldType::ramp:
        return ramp();
    }
    return {};
  }
  std::mt19937 random_;
};

TEST(SettingsFile, random_settings_read_back_equal) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Settings settings = RandomSettings(seed).make();
    const std::string text = settings_text(settings);
    const Settings again = parse_settings(text, "seed " + std::to_string(seed), "/elsewhere");
    expect_equal(settings, again);
    EXPECT_EQ(settings_text(again), text);
  }
}

TEST(SettingsFile, an_empty_file_is_the_defaults) {
  expect_equal(parsed_settings(""), Settings{});
  expect_equal(parsed_settings("title = \"a title is for people\"\n"), Settings{});
}

TEST(SettingsFile, the_paper_scene_has_the_papers_values) {
  Settings settings = load_settings(project_file("data/scenes/paper.toml"));
  EXPECT_NO_THROW(check_settings(settings));
  EXPECT_EQ(settings.camera.near, 0.1F);
  EXPECT_EQ(settings.camera.far, 20.0F);
  EXPECT_EQ(settings.combine.k_depth, 0.003F);
  EXPECT_EQ(settings.combine.k_normal, 0.0125F);
  EXPECT_EQ(settings.combine.threshold, 0.75F);
  EXPECT_TRUE(settings.combine.use_depth && settings.combine.use_normal);
  EXPECT_EQ(settings.display.depth_edges_gain, 128.0F);
  EXPECT_EQ(settings.display.normal_edges_gain, 16.0F);
  EXPECT_EQ(settings.ink.colour, glm::vec3(0.0F));
  ASSERT_EQ(settings.models.size(), 3U);
  EXPECT_EQ(main_model(settings).mesh, "rabbit");
  EXPECT_EQ(settings.models[1].shape, Shape::box);
  EXPECT_EQ(settings.models[2].shape, Shape::inside_out_sphere);
  ASSERT_EQ(settings.lights.size(), 1U);
  EXPECT_TRUE(settings.ramp.enabled);
}

TEST(SettingsFile, every_bundled_scene_is_valid) {
  int scenes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(project_file("data/scenes"))) {
    if (entry.path().extension() != ".toml") continue;
    ++scenes;
    EXPECT_NO_THROW(check_settings(load_settings(entry.path()))) << entry.path();
  }
  EXPECT_GE(scenes, 2);
}

TEST(SettingsFile, models_and_lights_come_in_the_order_of_the_file) {
  const Settings settings = parsed_settings(
      "[[model]]\nname = \"b\"\nsize = 2\nmaterial.specular = 0.5\n[[model]]\nname = \"a\"\n[[light]]\nname "
      "= \"b\"\n");
  ASSERT_EQ(settings.models.size(), 2U);
  EXPECT_EQ(settings.models[0].name, "b");
  EXPECT_EQ(settings.models[0].size, 2.0F);
  EXPECT_EQ(settings.models[0].material.specular, 0.5F);
  EXPECT_EQ(settings.models[1].name, "a");
  EXPECT_EQ(settings.lights[0].name, "b");
}

TEST(SettingsFile, components_may_be_set_alone) {
  EXPECT_EQ(parsed_settings("camera.eye.x = 3").camera.eye, glm::vec3(3, 0, 5));
  EXPECT_EQ(parsed_settings("[ink]\ncolour.b = 1").ink.colour, glm::vec3(0, 0, 1));
}

class SceneFiles : public ::testing::Test {
 protected:
  std::string load_error(const std::string& name) {
    return error_of([&] { load_settings(folder_.path() / name); });
  }
  std::string at(const std::string& name, int line) {
    return (folder_.path() / name).string() + ":" + std::to_string(line) + ": ";
  }
  const TemporaryFolder folder_;
};

TEST_F(SceneFiles, base_is_where_a_scene_starts_from) {
  folder_.write("one.toml",
                "[combine]\nk_depth = 0.5\nk_normal = 0.5\n[[model]]\nname = \"rabbit\"\nsize = "
                "1\n[[light]]\nname = \"key\"\n");
  folder_.write("deeper/two.toml",
                "base = \"../one.toml\"\ncombine.k_depth = 0.25\n[[model]]\nname = \"box\"\n");
  folder_.write("three.toml",
                "base = \"deeper/two.toml\"\n[[model]]\nname = \"rabbit\"\nsize = 3\n[[light]]\nname = "
                "\"key\"\ndiffuse = 0.5\n");
  const Settings settings = load_settings(folder_.path() / "three.toml");
  EXPECT_EQ(settings.combine.k_depth, 0.25F);
  EXPECT_EQ(settings.combine.k_normal, 0.5F);
  ASSERT_EQ(settings.models.size(), 2U) << "a known name changes that model";
  EXPECT_EQ(settings.models[0].name, "rabbit");
  EXPECT_EQ(settings.models[0].size, 3.0F);
  EXPECT_EQ(settings.models[1].name, "box");
  ASSERT_EQ(settings.lights.size(), 1U);
  EXPECT_EQ(settings.lights[0].diffuse, glm::vec3(0.5F));
}

TEST_F(SceneFiles, the_dotted_form_changes_a_bases_model) {
  folder_.write("one.toml", "[[model]]\nname = \"rabbit\"\nsize = 1\n");
  folder_.write("two.toml", "base = \"one.toml\"\nmodel.rabbit.size = 5\nmodel.rabbit.position.y = 2\n");
  const Settings settings = load_settings(folder_.path() / "two.toml");
  EXPECT_EQ(settings.models[0].size, 5.0F);
  EXPECT_EQ(settings.models[0].position, glm::vec3(0, 2, 0));
  folder_.write("three.toml", "base = \"one.toml\"\n\n[model.box]\nsize = 5\n");
  EXPECT_EQ(load_error("three.toml").find(at("three.toml", 4) + "unknown parameter 'model.box.size'"), 0U);
}

TEST_F(SceneFiles, a_circle_of_bases_is_an_error) {
  folder_.write("self.toml", "\nbase = \"self.toml\"\n");
  EXPECT_THAT(load_error("self.toml"),
              AllOf(StartsWith(at("self.toml", 2)), HasSubstr("may not refer to each other in a circle")));
  folder_.write("a.toml", "base = \"b.toml\"\n");
  folder_.write("b.toml", "base = \"./a.toml\"\n");
  EXPECT_THAT(load_error("a.toml"),
              AllOf(StartsWith(at("a.toml", 1)), HasSubstr(at("b.toml", 1)), HasSubstr("in a circle")));
}

TEST_F(SceneFiles, a_chain_of_bases_has_an_end) {
  folder_.write("0.toml", "");
  for (int i = 1; i <= 40; ++i) {
    folder_.write(std::to_string(i) + ".toml", "base = \"" + std::to_string(i - 1) + ".toml\"\n");
  }
  EXPECT_NO_THROW(load_settings(folder_.path() / "15.toml"));
  EXPECT_THAT(load_error("40.toml"), HasSubstr("`base` is nested too deeply"));
}

TEST_F(SceneFiles, a_missing_base_is_an_error_with_the_line_that_names_it) {
  folder_.write("a.toml", "\n\nbase = \"none.toml\"\n");
  EXPECT_EQ(load_error("a.toml"),
            at("a.toml", 3) + "base: " + (folder_.path() / "none.toml").string() + ": no such file");
  folder_.write("b.toml", "base = \".\"\n");
  EXPECT_THAT(load_error("b.toml"), HasSubstr("is a folder"));
  folder_.write("c.toml", "base = 3\n");
  EXPECT_EQ(load_error("c.toml"), at("c.toml", 1) + "base is a number; it must be a scene file's path");
}

TEST_F(SceneFiles, an_error_in_a_base_names_both_files) {
  folder_.write("one.toml", "\ncombine.k_dept = 1\n");
  folder_.write("two.toml", "base = \"one.toml\"\n");
  EXPECT_THAT(load_error("two.toml"),
              AllOf(StartsWith(at("two.toml", 1)), HasSubstr(at("one.toml", 2) + "unknown parameter")));
}

TEST_F(SceneFiles, a_missing_scene_is_an_error) {
  EXPECT_EQ(load_error("none.toml"), (folder_.path() / "none.toml").string() + ": no such file");
}

TEST_F(SceneFiles, relative_paths_start_from_the_file_that_says_them) {
  folder_.write("deeper/one.toml",
                "[[model]]\nname = \"m\"\nmesh = \"m.obj\"\n[ramp]\ndiffuse = \"../r.png\"\n");
  folder_.write("two.toml", "base = \"deeper/one.toml\"\nramp.specular = \"s.png\"\n");
  const Settings settings = load_settings(folder_.path() / "two.toml");
  EXPECT_EQ(settings.models[0].mesh, folder_.path() / "deeper/m.obj");
  EXPECT_EQ(settings.ramp.diffuse.image, folder_.path() / "r.png");
  EXPECT_EQ(settings.ramp.specular.image, folder_.path() / "s.png");
}

TEST_F(SceneFiles, a_scene_given_by_a_relative_path_still_has_absolute_ones) {
  folder_.write("one.toml", "[[model]]\nname = \"m\"\nmesh = \"m.obj\"\n");
  const Settings settings = load_settings(fs::relative(folder_.path() / "one.toml"));
  EXPECT_EQ(settings.models[0].mesh, folder_.path() / "m.obj");
}

TEST(SettingsFile, unknown_keys_at_any_depth_are_errors_with_their_line) {
  EXPECT_THAT(settings_error("\nnonsense = 1\n"), StartsWith("a.toml:2: unknown parameter 'nonsense'"));
  EXPECT_EQ(settings_error("[combine]\nk_dept = 1\n"),
            "a.toml:2: unknown parameter 'combine.k_dept'; did you mean 'combine.k_depth'?");
  EXPECT_THAT(settings_error("[combin]\nk_depth = 1\n"),
              StartsWith("a.toml:2: unknown parameter 'combin.k_depth'"));
  EXPECT_THAT(settings_error("[[model]]\nname = \"m\"\nmaterial.colr = 1\n"),
              StartsWith("a.toml:3: unknown parameter 'model.m.material.colr'"));
  EXPECT_THAT(settings_error("[[light]]\nname = \"l\"\n\nsize = 1\n"),
              StartsWith("a.toml:4: unknown parameter 'light.l.size'"));
  EXPECT_THAT(settings_error("[combine.k_depth]\nvalue = 1\n"),
              StartsWith("a.toml:2: unknown parameter 'combine.k_depth.value'"));
  EXPECT_THAT(settings_error("camera.eye.w = 1\n"), StartsWith("a.toml:1: unknown parameter 'camera.eye.w'"));
  EXPECT_THAT(settings_error("[camera]\neye = {x = 1, q = 2}\n"),
              StartsWith("a.toml:2: unknown parameter 'camera.eye.q'"));
}

TEST(SettingsFile, empty_tables_of_no_group_are_errors_too) {
  EXPECT_THAT(settings_error("\n[combin]\n"), StartsWith("a.toml:2: unknown parameter 'combin'"));
  EXPECT_THAT(settings_error("[model.rabit]\n"), StartsWith("a.toml:1: unknown parameter 'model.rabit'"));
  EXPECT_THAT(settings_error("combine.k_depth = {}\n"),
              StartsWith("a.toml:1: combine.k_depth is a table; it must be a number"));
  EXPECT_NO_THROW(parsed_settings("[combine]\n[camera]\n[[model]]\nname = \"m\"\nmaterial = {}\n"));
}

TEST(SettingsFile, a_key_given_twice_is_an_error) {
  EXPECT_THAT(settings_error("combine.k_depth = 0.1\ncombine.k_depth = 0.2\n"),
              StartsWith("a.toml:2: not valid TOML"));
  EXPECT_THAT(settings_error("[combine]\nk_depth = 0.1\n[combine]\nk_normal = 0.2\n"),
              StartsWith("a.toml:3: not valid TOML"));
  EXPECT_EQ(settings_error("camera.eye.x = 1\ncamera.eye.r = 2\n"),
            "a.toml:2: camera.eye.r and camera.eye.x are the same; give one of them");
  EXPECT_THAT(settings_error("camera.eye = 1\ncamera.eye.x = 2\n"), StartsWith("a.toml:2: not valid TOML"));
  EXPECT_THAT(settings_error("combine.k_depth = 0.1\n\"combine.k_depth\" = 0.2\n"),
              StartsWith("a.toml:2: the key 'combine.k_depth' is quoted, so its dots do not separate parts"));
}

TEST(SettingsFile, names_must_differ) {
  EXPECT_EQ(settings_error("[[model]]\nname = \"m\"\n[[model]]\nname = \"m\"\n"),
            "a.toml:3: a second [[model]] is named 'm'; names must differ");
  EXPECT_EQ(settings_error("[[light]]\nname = \"l\"\n[[light]]\nname = \"l\"\n"),
            "a.toml:3: a second [[light]] is named 'l'; names must differ");
}

TEST(SettingsFile, models_and_lights_need_names) {
  EXPECT_EQ(settings_error("\n[[model]]\nsize = 1\n"),
            "a.toml:2: a [[model]] without a name; give it one: name = \"box\"");
  EXPECT_THAT(settings_error("[[model]]\nname = 7\n"), StartsWith("a.toml:1: a [[model]] without a name"));
  EXPECT_THAT(settings_error("[[light]]\n"), StartsWith("a.toml:1: a [[light]] without a name"));
}

TEST(SettingsFile, names_must_be_fit_for_keys) {
  for (const char* name : {"", "a.b", "a b", "caf\xc3\xa9", "a\\\"", "<name>"}) {
    EXPECT_THAT(settings_error(std::string("[[model]]\nname = \"") + name + "\"\n"),
                AllOf(StartsWith("a.toml:2: the name \""), HasSubstr("cannot be part of a key")));
  }
  EXPECT_NO_THROW(parsed_settings("[[model]]\nname = \"A-b_9\"\n"));
}

TEST(SettingsFile, lists_hold_tables) {
  EXPECT_EQ(settings_error("\nmodel = [1]\n"), "a.toml:2: model holds a number; it is a list of tables");
  EXPECT_THAT(settings_error("light = [[]]\n"), StartsWith("a.toml:1: light holds a list of 0"));
  EXPECT_THAT(settings_error("model = 3\n"), StartsWith("a.toml:1: unknown parameter 'model'"));
  EXPECT_THAT(settings_error("model = \"rabbit\"\n"), StartsWith("a.toml:1: unknown parameter 'model'"));
  EXPECT_THAT(settings_error("[[combine]]\nk_depth = 1\n"),
              StartsWith("a.toml:1: unknown parameter 'combine'"));
}

TEST(SettingsFile, wrong_types_and_values_name_file_line_and_key) {
  EXPECT_EQ(settings_error("[combine]\nk_depth = \"much\"\n"),
            "a.toml:2: combine.k_depth is the text \"much\"; it must be a number from 1e-06 to 1");
  EXPECT_EQ(settings_error("\n\ncombine.k_depth = 7\n"),
            "a.toml:3: combine.k_depth = 7 is out of range; it must be a number from 1e-06 to 1");
  EXPECT_THAT(settings_error("combine.use_depth = 1\n"),
              StartsWith("a.toml:1: combine.use_depth is a number; it must be true or false"));
  EXPECT_THAT(settings_error("image.width = 2.5\n"),
              StartsWith("a.toml:1: image.width is a number; it must be a whole number"));
  EXPECT_THAT(settings_error("camera.eye = [1, 2]\n"),
              StartsWith("a.toml:1: camera.eye is a list of 2; it must be three numbers"));
  EXPECT_THAT(settings_error("[[model]]\nname = \"m\"\nshape = \"ball\"\n"),
              StartsWith("a.toml:3: model.m.shape = \"ball\" is not one of its choices"));
  EXPECT_THAT(settings_error("[[model]]\nname = \"m\"\nmesh = 3\n"),
              StartsWith("a.toml:3: model.m.mesh is a number; it must be the path of a file"));
  EXPECT_THAT(settings_error("ink.colour = \"black\"\n"),
              StartsWith("a.toml:1: ink.colour is the text \"black\"; it must be a colour"));
  EXPECT_EQ(settings_error("title = 3\n"), "a.toml:1: title is a number; it must be text");
}

TEST(SettingsFile, numbers_that_are_not_finite_are_errors) {
  for (const char* number : {"nan", "inf", "-inf", "1e39"}) {
    EXPECT_THAT(settings_error(std::string("combine.threshold = ") + number),
                StartsWith("a.toml:1: combine.threshold = "));
  }
}

TEST(SettingsFile, apply_table_changes_what_it_names_and_nothing_else) {
  Settings settings = parsed_settings("[[model]]\nname = \"m\"\n");
  Settings expected = settings;
  expected.combine.k_depth = 0.5F;
  expected.models[0].position.y = 3.0F;
  apply_table(settings, parse_toml("combine.k_depth = 0.5\nmodel.m.position.y = 3", "b.toml"), "b.toml", "/");
  expect_equal(settings, expected);
  EXPECT_THAT(error_of([&] { apply_table(settings, parse_toml("\nbase = \"x\"", "b.toml"), "b.toml", "/"); }),
              StartsWith("b.toml:2: unknown parameter 'base'"));
}

TEST(SettingsFile, thousands_of_models_are_read) {
  Settings settings;
  for (int i = 0; i < 2000; ++i) settings.models.emplace_back().name = "m" + std::to_string(i);
  const std::string text = settings_text(settings);
  expect_equal(parsed_settings(text), settings);
  std::string too_many;
  for (int i = 0; i < 4097; ++i) too_many += "[[model]]\nname = \"m" + std::to_string(i) + "\"\n";
  EXPECT_THAT(settings_error(too_many), HasSubstr("too many [[model]] tables"));
}

}  // namespace
}  // namespace inkbench
