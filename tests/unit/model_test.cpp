// SPDX-License-Identifier: MIT
// Where models stand, and which mesh they draw.
#include "pipeline/settings/model.h"
#include "pipeline/mesh/levels/model_mesh.h"

#include <gmock/gmock.h>

#include <glm/vec4.hpp>

#include "tests/unit/support.h"

namespace inkbench {
namespace {

const Bounds kBounds{{-1, 2, -3}, {3, 4, 5}};  // 4 x 2 x 8, its base's middle at (1, 2, 1)

void expect_place(const glm::vec3& actual, const glm::vec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-5F) << "component " << i;
}

glm::vec3 placed(const ModelParams& model, const glm::vec3& point, const Bounds& bounds = kBounds) {
  return glm::vec3(model_matrix(model, bounds) * glm::vec4(point, 1.0F));
}

TEST(ModelMatrix, the_default_leaves_the_mesh_where_it_is) {
  EXPECT_EQ(model_matrix(ModelParams{}, kBounds), glm::mat4(1.0F));
}

TEST(ModelMatrix, size_is_the_longest_side) {
  ModelParams model;
  model.size = 4.0F;  // of 8
  expect_place(placed(model, kBounds.high) - placed(model, kBounds.low), {2, 1, 4});
  expect_place(placed(model, {0, 0, 0}), {0, 0, 0});
}

TEST(ModelMatrix, the_base_stands_on_position) {
  ModelParams model;
  model.anchor = Anchor::base;
  model.position = {10, 20, 30};
  expect_place(placed(model, {1, 2, 1}), {10, 20, 30});
  model.size = 16.0F;
  expect_place(placed(model, {1, 2, 1}), {10, 20, 30});
  expect_place(placed(model, {1, 4, 1}), {10, 24, 30});
}

TEST(ModelMatrix, the_origin_stands_on_position) {
  ModelParams model;
  model.position = {10, 20, 30};
  model.size = 16.0F;
  expect_place(placed(model, {0, 0, 0}), {10, 20, 30});
  expect_place(placed(model, {1, 0, 0}), {12, 20, 30});
}

TEST(ModelMatrix, turns_are_counter_clockwise_about_each_axis) {
  ModelParams model;
  model.rotation = {90, 0, 0};
  expect_place(placed(model, {0, 1, 0}), {0, 0, 1});
  model.rotation = {0, 90, 0};
  expect_place(placed(model, {0, 0, 1}), {1, 0, 0});
  model.rotation = {0, 0, 90};
  expect_place(placed(model, {1, 0, 0}), {0, 1, 0});
}

TEST(ModelMatrix, turns_about_x_then_y_then_z) {
  ModelParams model;
  model.rotation = {90, 90, 0};
  expect_place(placed(model, {0, 1, 0}), {1, 0, 0});  // x: to +z; y: +z to +x
  model.rotation = {0, 90, 90};
  expect_place(placed(model, {0, 0, 1}), {0, 1, 0});  // y: to +x; z: +x to +y
  model.rotation = {90, 0, 90};
  expect_place(placed(model, {1, 0, 0}), {0, 1, 0});  // x leaves it; z: to +y
}

TEST(ModelMatrix, stretches_along_the_models_own_axes_before_turning) {
  ModelParams model;
  model.scale = {2, 1, 1};
  model.rotation = {0, 0, 90};
  expect_place(placed(model, {1, 1, 0}), {-1, 2, 0});
}

TEST(ModelMatrix, turns_about_the_anchor) {
  ModelParams model;
  model.anchor = Anchor::base;
  model.rotation = {0, 180, 0};
  model.scale = {3, 3, 3};
  expect_place(placed(model, {1, 2, 1}), {0, 0, 0});
  expect_place(placed(model, {2, 2, 1}), {-3, 0, 0});
}

TEST(ModelMatrix, a_mesh_without_extent_stays_finite) {
  ModelParams model;
  model.anchor = Anchor::base;
  model.size = 2.0F;
  expect_place(placed(model, {1, 1, 1}, {{1, 1, 1}, {1, 1, 1}}), {0, 0, 0});
}

TEST(ModelMesh, every_shape_makes_its_mesh) {
  for (int shape = 1; shape < static_cast<int>(ChoiceNames<Shape>::names.size()); ++shape) {
    ModelParams model;
    model.shape = static_cast<Shape>(shape);
    model.segments = 4;
    EXPECT_GT(make_model_mesh(model).triangles.size(), 0U)
        << ChoiceNames<Shape>::names[static_cast<size_t>(shape)];
  }
}

TEST(ModelMesh, segments_fillet_and_tube_reach_the_shape) {
  ModelParams model;
  model.shape = Shape::box;
  model.segments = 3;
  EXPECT_EQ(make_model_mesh(model).triangles.size(), 6U * 3 * 3 * 2);
  model.shape = Shape::torus;
  model.tube = 0.25F;
  EXPECT_NEAR(bounds_of(make_model_mesh(model)).high.y, 0.25F, 0.05F);
  model.shape = Shape::rounded_box;
  model.fillet = 0.0F;
  const size_t sharp = make_model_mesh(model).triangles.size();
  model.fillet = 0.25F;
  EXPECT_NE(make_model_mesh(model).triangles.size(), sharp);
}

TEST(ModelMesh, a_mesh_is_read_from_its_file) {
  const TemporaryFolder folder;
  ModelParams model;
  model.mesh = folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(make_model_mesh(model).triangles.size(), 1U);
  model.mesh = folder.path() / "none.obj";
  EXPECT_THAT(error_of([&] { make_model_mesh(model); }), ::testing::HasSubstr("none.obj"));
}

}  // namespace
}  // namespace inkbench
