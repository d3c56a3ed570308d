// SPDX-License-Identifier: MIT
// Differences between settings: every parameter is seen, and a list of changes leads from one to the other.
#include "app/workbench/param_changes.h"

#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Another valid value of the parameter.
Value another(const Param& param) {
  const Field& field = *param.field;
  const Value value = param.value();
  if (const auto* flag = std::get_if<bool>(&value)) return !*flag;
  if (const auto* number = std::get_if<int>(&value))
    return *number == static_cast<int>(field.limits.low) ? *number + 1 : *number - 1;
  const auto low = static_cast<float>(field.limits.low);
  if (const auto* number = std::get_if<float>(&value)) return *number == low ? (low + 1.0F) / 2.0F : low;
  if (std::holds_alternative<glm::vec3>(value)) return glm::vec3(low, 0.25F, low);
  if (std::holds_alternative<Ramp>(value)) return Ramp{{{0.5F, glm::vec3(0.5F), false}}, ""};
  if (field.type != FieldType::choice) return std::string("/another/file");
  const auto* name = std::get_if<std::string>(&value);
  return std::string(*name == field.choices[0] ? field.choices[1] : field.choices[0]);
}

TEST(ParamChanges, equal_settings_have_none) {
  EXPECT_THAT(changed_params(paper_settings(), paper_settings()), IsEmpty());
  EXPECT_TRUE(same_settings(paper_settings(), paper_settings()));
}

TEST(ParamChanges, each_parameter_is_seen_alone_and_can_be_put_back) {
  Settings before = paper_settings();
  for (const Param& known : list_params(before)) {
    Settings after = paper_settings();
    const Param param = find_param(after, known.key, "test");
    param.field->set(param.owner, another(param));
    const std::vector<ParamChange> changes = changed_params(before, after);
    ASSERT_THAT(changes, SizeIs(1)) << known.key;
    EXPECT_EQ(changes[0].key, known.key);
    EXPECT_FALSE(same_settings(before, after));
    Settings moved = before;
    apply_changes(moved, changes);
    EXPECT_EQ(text(moved), text(after));
    apply_changes(moved, changes, false);
    EXPECT_EQ(text(moved), text(before));
  }
}

TEST(ParamChanges, models_and_lights_that_come_or_go_have_one_side_only) {
  const Settings before = paper_settings();
  Settings after = before;
  after.models.erase(after.models.begin());
  after.lights.emplace_back().name = "fill";
  EXPECT_FALSE(same_structure(before, after));
  EXPECT_FALSE(same_settings(before, after));
  int gone = 0;
  int come = 0;
  for (const ParamChange& change : changed_params(before, after)) {
    if (!change.after) ++gone;
    if (!change.before) ++come;
    EXPECT_EQ(!change.after, change.key.starts_with("model.rabbit.")) << change.key;
    EXPECT_EQ(!change.before, change.key.starts_with("light.fill.")) << change.key;
  }
  EXPECT_GT(gone, 10);
  EXPECT_EQ(come, 6);
  EXPECT_EQ(changes_name(changed_params(before, after)), "other models or lights");
}

TEST(ParamChanges, another_order_of_models_is_another_structure) {
  Settings after = paper_settings();
  std::swap(after.models[0], after.models[1]);
  EXPECT_FALSE(same_structure(paper_settings(), after));
  EXPECT_FALSE(same_settings(paper_settings(), after));
}

std::string name_after(const std::vector<std::pair<std::string, Value>>& values) {
  Settings after = paper_settings();
  for (const auto& [key, value] : values) set(after, key, value);
  return changes_name(changed_params(paper_settings(), after));
}

TEST(ParamChanges, one_change_is_named_by_its_values) {
  EXPECT_EQ(name_after({{"combine.k_depth", 0.001F}}), "combine.k_depth 0.003 -> 0.001");
  EXPECT_EQ(name_after({{"combine.use_depth", false}}), "combine.use_depth true -> false");
  EXPECT_EQ(name_after({{"image.precision", std::string("unorm8")}}), "image.precision float -> unorm8");
  EXPECT_EQ(name_after({{"model.rabbit.mesh", std::string("/a/head.ply")}}),
            "model.rabbit.mesh rabbit -> head.ply");
  EXPECT_EQ(name_after({}), "no change");
}

TEST(ParamChanges, a_change_too_small_for_four_digits_shows_all_of_them) {
  EXPECT_EQ(name_after({{"combine.k_depth", 0.0030000010F}}), "combine.k_depth 0.003 -> 0.003000001");
}

TEST(ParamChanges, one_component_is_named_alone) {
  EXPECT_EQ(name_after({{"camera.eye", glm::vec3(2.4F, 4.0F, 9.6F)}}), "camera.eye.y 3.5 -> 4");
  EXPECT_EQ(name_after({{"model.box.material.colour", glm::vec3(0.35F, 0.55F, 0.5F)}}),
            "model.box.material.colour.b 0.8 -> 0.5");
  EXPECT_EQ(name_after({{"camera.eye", glm::vec3(1.0F, 2.0F, 3.0F)}}), "camera.eye 2.4, 3.5, 9.6 -> 1, 2, 3");
}

TEST(ParamChanges, ramps_with_as_many_stops_are_named_without_values) {
  Settings after = paper_settings();
  after.ramp.diffuse.stops[1].position = 0.25F;
  EXPECT_EQ(changes_name(changed_params(paper_settings(), after)), "ramp.diffuse");
  after.ramp.diffuse.stops.pop_back();
  EXPECT_EQ(changes_name(changed_params(paper_settings(), after)), "ramp.diffuse 4 stops -> 3 stops");
}

TEST(ParamChanges, several_of_one_group_are_named_by_it) {
  EXPECT_EQ(name_after({{"combine.k_depth", 0.1F}, {"combine.k_normal", 0.1F}}), "combine.k_depth, k_normal");
  EXPECT_EQ(name_after({{"camera.eye", glm::vec3(1)},
                        {"camera.target", glm::vec3(0)},
                        {"camera.fov", 50.0F},
                        {"camera.far", 50.0F}}),
            "camera (4 parameters)");
  EXPECT_EQ(name_after({{"model.box.size", 1.0F}, {"model.box.material.ambient", 0.5F}}),
            "model.box.size, material.ambient");
}

TEST(ParamChanges, several_groups_are_counted) {
  EXPECT_EQ(name_after({{"camera.fov", 50.0F}, {"combine.k_normal", 0.1F}, {"model.box.size", 1.0F}}),
            "3 parameters");
  EXPECT_EQ(name_after({{"model.rabbit.size", 1.0F}, {"model.box.size", 1.0F}}), "2 parameters");
}

}  // namespace
}  // namespace inkbench
