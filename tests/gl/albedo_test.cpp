// SPDX-License-Identifier: MIT
// Materials by pixel, and the lines that only they make.
#include "pipeline/passes/gbuffer/albedo.h"

#include <gtest/gtest.h>

#include <set>

#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

TEST(Albedo, is_each_models_colour_and_equal_materials_have_one_number) {
  Settings settings = analytic_scene();
  settings.models[2].material = settings.models[0].material;
  Pipeline pipeline;
  const Frame frame = pipeline.at(settings);
  const Image ids = frame.raw(BufferName::object_id), albedo = frame.raw(BufferName::albedo),
              materials = frame.raw(BufferName::material_id);
  std::set<float> seen;
  for (int y = 0; y < ids.height_px; ++y) {
    for (int x = 0; x < ids.width_px; ++x) {
      const int id = static_cast<int>(ids.at(x, y));
      seen.insert(materials.at(x, y));
      ASSERT_EQ(materials.at(x, y), (std::array{0.0F, 1.0F, 2.0F, 1.0F}[id]));
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(albedo.at(x, y, c), id == 0 ? 0.0F : settings.models[id - 1].material.colour[c]);
    }
  }
  EXPECT_EQ(seen.size(), 3U);
}

TEST(Albedo, picture_of_the_numbers_has_a_colour_for_each) {
  const Settings settings = analytic_scene();
  Pipeline pipeline;
  EXPECT_EQ(pipeline.at(settings).picture(BufferName::material_id),
            pipeline.at(settings).picture(BufferName::object_id))
      << "three models of three materials";
}

TEST(Albedo, knows_the_material_of_a_model_beyond_a_row_of_the_table) {
  Settings settings = small_scene();
  const ModelParams hidden{.name = "hidden", .visible = false, .shape = Shape::plane, .segments = 1};
  ModelParams ball = settings.models[0];
  ball.material.colour = {0.25F, 0.5F, 0.75F};
  settings.models.clear();
  for (int i = 0; i < 300; ++i) {
    settings.models.push_back(hidden);
    settings.models.back().name += std::to_string(i);
  }
  settings.models.push_back(ball);
  Pipeline pipeline;
  const Frame frame = pipeline.at(settings);
  EXPECT_EQ(frame.pixel(BufferName::object_id, 24, 20).at(0, 0), 301.0F);
  EXPECT_EQ(frame.pixel(BufferName::albedo, 24, 20).samples, (std::vector{0.25F, 0.5F, 0.75F}));
  EXPECT_EQ(frame.pixel(BufferName::material_id, 24, 20).at(0, 0), 2.0F);
}

TEST(Albedo, a_change_of_colour_draws_nothing_again_and_one_that_light_alone_sees_makes_no_table) {
  Settings settings = small_scene();
  Pipeline pipeline;
  pipeline.at(settings).draw(BufferName::albedo);
  settings.models[0].material.specular = 0.9F;
  pipeline.at(settings).draw(BufferName::albedo);
  EXPECT_EQ(pipeline.counts()["albedo"].runs, 1);
  settings.models[0].material.colour.x = 0.1F;
  pipeline.at(settings).draw(BufferName::albedo);
  EXPECT_EQ(pipeline.counts()["albedo"].runs, 2);
  EXPECT_EQ(pipeline.counts()["gbuffer"].runs, 1);
}

/// Two squares in one plane that meet in the image's middle.
Settings two_colours(float difference) {
  Settings settings;
  settings.image = {32, 24, Precision::float32};
  settings.camera = {{0.0F, 0.0F, 5.0F}, {0.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, 20.0F, 0.1F, 20.0F};
  for (const float side : {-1.0F, 1.0F}) {
    ModelParams square{
        .name = side < 0 ? "left" : "right", .shape = Shape::plane, .segments = 1, .size = 8.0F};
    square.position = {4.0F * side, 0.0F, 0.0F};
    square.rotation = {90.0F, 0.0F, 0.0F};
    square.material.colour = {0.5F, 0.5F + (side < 0 ? 0.0F : difference), 0.5F};
    settings.models.push_back(square);
  }
  settings.edges.method = EdgeMethod::mitchell;
  settings.mitchell.use_ids = false;
  return settings;
}

TEST(Albedo, border_of_two_colours_in_one_plane_is_mitchells_line_of_class_material) {
  Pipeline pipeline;
  const auto class_at = [&](const Settings& settings, int x) {
    return static_cast<EdgeClass>(
        static_cast<int>(pipeline.at(settings).pixel(BufferName::edge_class, x, 12).at(0, 0)));
  };
  Settings settings = two_colours(0.11F);  // the limit is 0.1
  EXPECT_EQ(class_at(settings, 15), EdgeClass::material);
  EXPECT_EQ(class_at(settings, 16), EdgeClass::material);
  EXPECT_EQ(class_at(settings, 14), EdgeClass::none);
  EXPECT_EQ(class_at(two_colours(0.09F), 15), EdgeClass::none);
  settings.mitchell.use_ids = true;
  EXPECT_EQ(class_at(settings, 15), EdgeClass::object) << "that they are two models says more";
}

}  // namespace
}  // namespace inkbench
