// SPDX-License-Identifier: MIT
// Another mesh in the place of the main model: as large as the old one and on the same spot.
#include "pipeline/mesh/levels/replace_mesh.h"
#include "pipeline/mesh/levels/model_mesh.h"

#include <gmock/gmock.h>

#include <glm/vec4.hpp>

#include "tests/unit/support.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;

class ReplaceMesh : public ::testing::Test {
 protected:
  ReplaceMesh() {
    settings_.models.emplace_back().name = "floor";
    settings_.models[0].shape = Shape::plane;
    settings_.models.emplace_back().name = "old";
    // 2 x 4 x 2, its base's middle at (3, 1, 5)
    old().mesh = folder_.write("old.obj", "v 2 1 4\nv 4 1 6\nv 4 1 4\nv 3 5 5\nf 1 2 4\nf 2 3 4\nf 1 3 2\n");
  }
  ModelParams& old() { return settings_.models[1]; }
  fs::path tall() { return folder_.write("tall.obj", "v 0 0 0\nv 1 0 0\nv 0 40 0\nf 1 2 3\n"); }

  /// The box that the model fills in the world.
  Bounds world_bounds() {
    Mesh mesh = make_model_mesh(old());
    const glm::mat4 matrix = model_matrix(old(), bounds_of(mesh));
    for (glm::vec3& point : mesh.positions) point = glm::vec3(matrix * glm::vec4(point, 1.0F));
    return bounds_of(mesh);
  }
  static void expect_near(const glm::vec3& actual, const glm::vec3& expected) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-4F) << "component " << i;
  }
  static glm::vec3 base_of(const Bounds& bounds) {
    return {(bounds.low.x + bounds.high.x) / 2, bounds.low.y, (bounds.low.z + bounds.high.z) / 2};
  }
  static float longest_of(const Bounds& bounds) {
    const glm::vec3 extent = bounds.high - bounds.low;
    return std::max({extent.x, extent.y, extent.z});
  }
  void expect_same_place_and_size() {
    const Bounds before = world_bounds();
    replace_main_mesh(settings_, tall());
    const Bounds after = world_bounds();
    expect_near(base_of(after), base_of(before));
    EXPECT_NEAR(longest_of(after), longest_of(before), 1e-4F);
  }

  const TemporaryFolder folder_;
  Settings settings_;
};

TEST_F(ReplaceMesh, keeps_place_and_size_of_a_model_in_its_own_units) {
  expect_same_place_and_size();
}

TEST_F(ReplaceMesh, keeps_place_and_size_of_a_sized_model_on_its_origin) {
  old().size = 2.0F;
  old().position = {1, 2, 3};
  expect_same_place_and_size();
}

TEST_F(ReplaceMesh, keeps_place_and_size_of_a_model_on_its_base) {
  old().size = 2.0F;
  old().anchor = Anchor::base;
  old().position = {1, 2, 3};
  expect_same_place_and_size();
}

TEST_F(ReplaceMesh, keeps_place_and_size_of_an_unsized_model_on_its_base) {
  old().anchor = Anchor::base;
  old().position = {1, 2, 3};
  expect_same_place_and_size();
}

TEST_F(ReplaceMesh, keeps_place_and_size_of_a_turned_model) {
  old().position = {1, 2, 3};
  old().rotation = {0, 90, 0};
  expect_same_place_and_size();
}

TEST_F(ReplaceMesh, does_not_read_the_old_mesh_when_its_place_is_known) {
  old().mesh = "/none.obj";
  old().size = 2.0F;
  old().anchor = Anchor::base;
  EXPECT_NO_THROW(replace_main_mesh(settings_, tall()));
  EXPECT_EQ(old().mesh, tall().string());
}

TEST_F(ReplaceMesh, needs_the_old_mesh_where_its_size_decides) {
  old().mesh = "/none.obj";
  EXPECT_THAT(error_of([&] { replace_main_mesh(settings_, tall()); }), ::testing::HasSubstr("/none.obj"));
}

TEST_F(ReplaceMesh, touches_the_main_model_only) {
  replace_main_mesh(settings_, tall());
  EXPECT_EQ(settings_.models[0].shape, Shape::plane);
  EXPECT_EQ(settings_.models[0].mesh, "rabbit");
  EXPECT_EQ(old().name, "old");
}

TEST_F(ReplaceMesh, replaces_a_built_in_shape_where_there_is_no_mesh) {
  settings_.models.pop_back();
  replace_main_mesh(settings_, tall());
  EXPECT_EQ(settings_.models[0].shape, Shape::mesh);
  EXPECT_EQ(settings_.models[0].mesh, tall().string());
}

TEST_F(ReplaceMesh, makes_relative_paths_absolute_and_knows_the_rabbit) {
  replace_main_mesh(settings_, fs::relative(tall()));
  EXPECT_EQ(old().mesh, tall().string());
  replace_main_mesh(settings_, "rabbit");
  EXPECT_EQ(old().mesh, "rabbit");
}

TEST(ReplaceMeshAlone, needs_a_model) {
  Settings settings;
  EXPECT_EQ(error_of([&] { replace_main_mesh(settings, "/a.obj"); }),
            "scene: has no models; add a [[model]] table");
}

}  // namespace
}  // namespace inkbench
