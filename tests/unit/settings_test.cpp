// SPDX-License-Identifier: MIT
// The description of all parameters, and finding and setting them by key.
#include "pipeline/settings/settings.h"

#include <gmock/gmock.h>

#include <set>

#include "pipeline/base/text.h"
#include "pipeline/params/toml_value.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

Settings scene() {
  Settings settings;
  settings.models.emplace_back().name = "rabbit";
  settings.models.emplace_back().name = "box";
  settings.lights.emplace_back().name = "key";
  return settings;
}

bool is_number(const Field& field) {
  return field.type == FieldType::integer || field.type == FieldType::real ||
         field.type == FieldType::vector || field.type == FieldType::colour;
}

TEST(Description, every_default_is_within_its_limits) {
  Settings settings = scene();
  for (const Param& param : list_params(settings)) {
    EXPECT_NO_THROW(check_value(*param.field, param.key, param.value(), "")) << param.key;
  }
}

TEST(Description, numbers_have_limits_and_a_slider_within_them) {
  Settings settings = scene();
  for (const Param& param : list_params(settings)) {
    const Field& field = *param.field;
    if (!is_number(field)) continue;
    EXPECT_LT(field.limits.low, field.limits.high) << param.key;
    EXPECT_LT(field.slider.low, field.slider.high) << param.key;
    EXPECT_GE(field.slider.low, field.limits.low) << param.key;
    EXPECT_LE(field.slider.high, field.limits.high) << param.key;
    if (field.scale == Scale::linear) continue;
    EXPECT_GT(field.slider.low, 0) << param.key << " is on a log scale";
  }
}

TEST(Description, choices_have_names_that_differ) {
  Settings settings = scene();
  for (const Param& param : list_params(settings)) {
    const auto& choices = param.field->choices;
    EXPECT_EQ(param.field->type == FieldType::choice, !choices.empty()) << param.key;
    EXPECT_EQ(std::set<std::string_view>(choices.begin(), choices.end()).size(), choices.size()) << param.key;
    for (const std::string_view choice : choices) EXPECT_FALSE(choice.empty()) << param.key;
  }
}

TEST(Description, every_choice_can_be_set_and_got) {
  Settings settings = scene();
  for (const Param& param : list_params(settings)) {
    for (const std::string_view choice : param.field->choices) {
      param.set(Value(std::string(choice)), "");
      EXPECT_EQ(param.value(), Value(std::string(choice))) << param.key;
    }
  }
}

TEST(Description, keys_are_unique_and_plain) {
  Settings settings = scene();
  std::set<std::string> keys;
  for (const Param& param : list_params(settings)) {
    EXPECT_TRUE(keys.insert(param.key).second) << param.key << " comes twice";
    EXPECT_EQ(param.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz_."), std::string::npos) << param.key;
  }
  EXPECT_GT(keys.size(), 50U);
}

TEST(Description, help_is_one_sentence_on_one_line) {
  Settings settings = scene();
  for (const Param& param : list_params(settings)) {
    EXPECT_TRUE(param.field->help.ends_with('.')) << param.key;
    EXPECT_EQ(param.field->help.find('\n'), std::string_view::npos) << param.key;
    EXPECT_GT(param.field->help.size(), 8U) << param.key;
  }
}

TEST(Description, matters_when_names_other_parameters_and_values_that_they_take) {
  Settings settings = scene();
  int conditions = 0;
  for (const ParamGroup& group : list_groups(settings)) {
    for (const Field& field : group.description->fields) {
      for (const Condition& condition : conditions_of(group, field)) {
        ++conditions;
        ASSERT_TRUE(has_param(settings, condition.key)) << field.name << ": " << condition.key;
        for (const std::string& value : condition.values)
          EXPECT_NO_THROW(set_param_text(settings, condition.key, value, "")) << field.name << ": " << value;
        EXPECT_NE(condition.key, group.prefix + "." + std::string(field.name)) << "its own condition";
      }
    }
  }
  EXPECT_GT(conditions, 5);
}

TEST(Condition, reads_keys_and_any_of_several_values) {
  const std::vector<Condition> read = parse_conditions("edges.method != paper and unit = px or percent");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].key, "edges.method");
  EXPECT_TRUE(read[0].is_unequal);
  EXPECT_EQ(read[1].values, (std::vector<std::string>{"px", "percent"}));
  EXPECT_FALSE(read[1].is_unequal);
  EXPECT_TRUE(parse_conditions("").empty());
  EXPECT_THROW(parse_conditions("use_depth"), Error);
}

TEST(Description, field_matters_as_its_condition_says) {
  Settings settings = scene();
  const auto is_live = [&](const std::string& key) {
    const Param param = find_param(settings, key, "");
    for (const ParamGroup& group : list_groups(settings)) {
      if (group.owner == param.owner) return matters(settings, group, *param.field);
    }
    return false;
  };
  EXPECT_TRUE(is_live("combine.k_depth"));
  settings.combine.use_depth = false;
  EXPECT_FALSE(is_live("combine.k_depth"));
  EXPECT_TRUE(is_live("combine.k_normal"));
  EXPECT_TRUE(is_live("combine.use_depth"));
  const std::string model = "model." + settings.models.front().name;
  settings.models.front().shape = Shape::torus;
  EXPECT_TRUE(is_live(model + ".tube"));
  EXPECT_TRUE(is_live(model + ".segments"));
  EXPECT_FALSE(is_live(model + ".mesh"));
  settings.models.front().shape = Shape::mesh;
  EXPECT_FALSE(is_live(model + ".tube"));
  EXPECT_FALSE(is_live(model + ".segments"));
  EXPECT_TRUE(is_live(model + ".mesh"));
}

TEST(Description, every_field_writes_where_it_reads) {
  Settings settings = scene();
  for (const Param& param : list_params(settings)) {
    Value changed = param.value();
    if (auto* boolean = std::get_if<bool>(&changed)) *boolean = !*boolean;
    if (auto* integer = std::get_if<int>(&changed)) *integer += 1;
    const auto inside = static_cast<float>(param.field->limits.low +
                                           0.3 * (param.field->limits.high - param.field->limits.low));
    if (auto* real = std::get_if<float>(&changed)) *real = inside;
    if (auto* vector = std::get_if<glm::vec3>(&changed)) vector->y = inside;
    if (auto* text = std::get_if<std::string>(&changed))
      *text = param.field->choices.empty()           ? "/x"
              : *text == param.field->choices.back() ? param.field->choices.front()
                                                     : param.field->choices.back();
    if (auto* ramp = std::get_if<Ramp>(&changed)) ramp->image = "/x.png";
    ASSERT_NE(changed, param.value()) << param.key;
    std::vector<Value> others;
    for (const Param& other : list_params(settings)) others.push_back(other.value());
    param.set(changed, "");
    EXPECT_EQ(param.value(), changed) << param.key;
    size_t i = 0;
    for (const Param& other : list_params(settings)) {
      const Value& before = others[i++];
      if (other.key == param.key) continue;
      EXPECT_EQ(other.value(), before) << param.key << " changed " << other.key;
    }
  }
}

TEST(Settings, every_listed_key_finds_its_own_parameter) {
  Settings settings = scene();
  for (const Param& param : list_params(settings)) {
    const Param found = find_param(settings, param.key, "");
    EXPECT_EQ(found.key, param.key);
    EXPECT_EQ(found.field, param.field) << param.key;
    EXPECT_EQ(found.owner, param.owner) << param.key;
    EXPECT_EQ(found.component, -1) << param.key;
    EXPECT_TRUE(has_param(settings, param.key));
  }
}

TEST(Settings, vectors_have_components_and_nothing_else_has) {
  Settings settings = scene();
  for (const Param& param : list_params(settings)) {
    const bool is_vector = std::holds_alternative<glm::vec3>(param.value());
    for (const char* name : {"x", "y", "z", "r", "g", "b"}) {
      EXPECT_EQ(has_param(settings, param.key + "." + name), is_vector) << param.key << "." << name;
    }
    for (const char* name : {"", "w", "a", "xx", "x.y"})
      EXPECT_FALSE(has_param(settings, param.key + "." + name)) << param.key << "." << name;
  }
  EXPECT_EQ(find_param(settings, "camera.eye.z", "").component, 2);
  EXPECT_EQ(find_param(settings, "ink.colour.g", "").component, 1);
}

TEST(Settings, keys_that_are_almost_right_are_not_found) {
  Settings settings = scene();
  for (const char* key : {"",
                          ".",
                          "combine",
                          "combine.",
                          "combine.k",
                          "combine.k_depthx",
                          "combine..k_depth",
                          ".combine.k_depth",
                          "model",
                          "model.rabbit",
                          "model.rabbit.",
                          "model..size",
                          "model.rabbi.size",
                          "model.rabbitx.size",
                          "model.rabbit.material",
                          "model.rabbit.material.",
                          "model.rabbit.name",
                          "light.rabbit.type",
                          "model.key.size",
                          "image.width.x"}) {
    EXPECT_FALSE(has_param(settings, key)) << key;
  }
}

TEST(Settings, one_models_name_may_begin_like_anothers) {
  Settings settings = scene();
  settings.models.emplace_back().name = "rab";
  settings.models.emplace_back().name = "material";
  set_param_text(settings, "model.rab.size", "3", "");
  set_param_text(settings, "model.rabbit.size", "4", "");
  set_param_text(settings, "model.material.material.specular", "0.5", "");
  EXPECT_EQ(settings.models[2].size, 3.0F);
  EXPECT_EQ(settings.models[0].size, 4.0F);
  EXPECT_EQ(settings.models[3].material.specular, 0.5F);
}

TEST(Settings, unknown_key_names_the_nearest_one) {
  Settings settings = scene();
  EXPECT_EQ(error_of([&] { find_param(settings, "combine.k_dept", "a.toml:7"); }),
            "a.toml:7: unknown parameter 'combine.k_dept'; did you mean 'combine.k_depth'?");
  EXPECT_THAT(error_of([&] { find_param(settings, "model.rabit.size", ""); }),
              HasSubstr("did you mean 'model.rabbit.size'?"));
  EXPECT_THAT(error_of([&] { find_param(settings, "zzzzzzzzzzzzzzzz", ""); }),
              HasSubstr("`inkbench params` lists them all"));
}

TEST(Settings, a_model_that_is_not_there_says_how_one_is_written) {
  Settings settings = scene();
  EXPECT_THAT(error_of([&] { find_param(settings, "model.wheel_left.size", "a.toml:7"); }),
              HasSubstr("there is no model 'wheel_left'; a scene file adds one with [[model]] and name = "
                        "\"wheel_left\" below it"));
  EXPECT_THAT(error_of([&] { find_param(settings, "light.sun2.type", ""); }), HasSubstr("[[light]]"));
}

TEST(Settings, assignments_are_key_equals_value) {
  Settings settings = scene();
  apply_assignment(settings, "combine.k_depth=0.005");
  EXPECT_EQ(settings.combine.k_depth, 0.005F);
  apply_assignment(settings, " combine.k_depth = 0.25 ");
  EXPECT_EQ(settings.combine.k_depth, 0.25F);
  apply_assignment(settings, "model.rabbit.mesh=/a=b.obj");
  EXPECT_EQ(settings.models[0].mesh, "/a=b.obj");
  apply_assignment(settings, "camera.up=0,0,1");
  EXPECT_EQ(settings.camera.up, glm::vec3(0, 0, 1));
}

TEST(Settings, bad_assignments_say_which) {
  Settings settings = scene();
  for (const char* text : {"", "=", "=1", "combine.k_depth"}) {
    EXPECT_EQ(error_of([&] { apply_assignment(settings, text); }),
              std::string("--set ") + text + ": is not KEY=VALUE; for example --set combine.k_depth=0.005");
  }
  EXPECT_THAT(error_of([&] { apply_assignment(settings, "combine.k_depth=2"); }),
              StartsWith("--set combine.k_depth=2: combine.k_depth = 2 is out of range"));
  EXPECT_THAT(error_of([&] { apply_assignment(settings, "combine.kdepth=2"); }),
              StartsWith("--set combine.kdepth=2: unknown parameter"));
}

TEST(CheckSettings, accepts_the_defaults) {
  EXPECT_NO_THROW(check_settings(Settings{}));
  EXPECT_NO_THROW(check_settings(scene()));
}

TEST(CheckSettings, eye_and_target_must_differ) {
  Settings settings = scene();
  settings.camera.target = settings.camera.eye;
  EXPECT_THAT(error_of([&] { check_settings(settings); }),
              StartsWith("camera.eye: is the same point as camera.target"));
}

TEST(CheckSettings, up_must_not_be_along_the_view) {
  for (const glm::vec3 up : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(0)}) {
    Settings settings = scene();
    settings.camera.up = up;
    EXPECT_THAT(error_of([&] { check_settings(settings); }), StartsWith("camera.up: is zero or parallel"));
  }
}

TEST(CheckSettings, near_must_be_below_far) {
  Settings settings = scene();
  settings.camera.near = 2.0F;
  settings.camera.far = 2.0F;
  EXPECT_EQ(error_of([&] { check_settings(settings); }), "camera.near: = 2 is not below camera.far = 2");
}

TEST(CheckSettings, names_must_differ) {
  Settings settings = scene();
  settings.models.emplace_back().name = "rabbit";
  EXPECT_EQ(error_of([&] { check_settings(settings); }), "model: two models are named 'rabbit'");
  settings.models.pop_back();
  settings.lights.emplace_back().name = "key";
  EXPECT_EQ(error_of([&] { check_settings(settings); }), "light: two lights are named 'key'");
  settings.lights.back().name = "rabbit";
  EXPECT_NO_THROW(check_settings(settings)) << "a light may be named like a model";
}

TEST(CheckSettings, a_directional_light_needs_a_direction) {
  Settings settings = scene();
  settings.lights[0].direction = glm::vec3(0.0F);
  EXPECT_THAT(error_of([&] { check_settings(settings); }), StartsWith("light.key.direction: is [0, 0, 0]"));
  settings.lights[0].type = LightType::point;
  EXPECT_NO_THROW(check_settings(settings));
}

TEST(MainModel, is_the_first_mesh_else_the_first) {
  Settings settings = scene();
  settings.models[0].shape = Shape::box;
  EXPECT_EQ(main_model(settings).name, "box") << "the second, which is a mesh";
  settings.models[1].shape = Shape::torus;
  EXPECT_EQ(main_model(settings).name, "rabbit");
  settings.models.clear();
  EXPECT_EQ(error_of([&] { main_model(settings); }), "scene: has no models; add a [[model]] table");
}

}  // namespace
}  // namespace inkbench
