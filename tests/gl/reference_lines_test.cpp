// SPDX-License-Identifier: MIT
// Reference lines with the pipeline's own depth and object-id buffers, and of the rabbit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/geometric.hpp>

#include "pipeline/base/text.h"
#include "pipeline/lines/reference_lines.h"
#include "pipeline/mesh/levels/model_mesh.h"
#include "pipeline/mesh/shapes/primitives.h"
#include "pipeline/passes/lines/reference.h"
#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

struct Extracted {
  ReferenceLines lines;
  Image depth, object_id;
};

Extracted extract(const Settings& settings) {
  Pipeline pipeline;
  Extracted result{
      {}, pipeline.at(settings).raw(BufferName::depth), pipeline.at(settings).raw(BufferName::object_id)};
  std::deque<MeshTopology> topologies;
  std::deque<MeshFeatures> features;
  std::vector<SceneMesh> scene;
  for (size_t i = 0; i < settings.models.size(); ++i) {
    if (!settings.models[i].visible) continue;
    const Mesh mesh = make_model_mesh(settings.models[i]);
    topologies.push_back(make_topology(mesh));
    features.push_back(make_features(topologies.back()));
    scene.push_back({&topologies.back(), model_matrix(settings.models[i], bounds_of(mesh)),
                     static_cast<int>(i) + 1, &features.back()});
  }
  result.lines = reference_lines(scene, settings.camera, result.depth, result.object_id);
  return result;
}

std::vector<Polyline> silhouettes_of(const ReferenceLines& lines, int object_id) {
  std::vector<Polyline> found;
  for (const Polyline& line : lines.polylines) {
    if (line.line_class == LineClass::silhouette && line.object_id == object_id) found.push_back(line);
  }
  return found;
}

bool line_near(const LineMap& map, int x, int y, int reach) {
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      if (map.contains(x + dx, y + dy) && map.at(x + dx, y + dy)) return true;
    }
  }
  return false;
}

/// Share of the pixels beside a border between an object and what lies behind it that have a silhouette of
/// that object within `reach` px.
double outline_share(const Extracted& extracted, int id, int reach) {
  LineMap map(extracted.lines.width_px, extracted.lines.height_px);
  for (const Polyline& line : silhouettes_of(extracted.lines, id)) draw_line(line, map);
  int covered = 0;
  int all = 0;
  for (int y = 1; y + 1 < map.height_px(); ++y) {
    for (int x = 1; x + 1 < map.width_px(); ++x) {
      if (std::lround(extracted.object_id.at(x, y)) != id) continue;
      bool is_outline = false;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        is_outline |= std::lround(extracted.object_id.at(x + dx, y + dy)) != id &&
                      extracted.depth.at(x + dx, y + dy) > extracted.depth.at(x, y);
      }
      all += is_outline ? 1 : 0;
      covered += is_outline && line_near(map, x, y, reach) ? 1 : 0;
    }
  }
  EXPECT_GT(all, 100);
  return static_cast<double>(covered) / all;
}

TEST(ReferenceLines, sphere_is_one_closed_circle_in_the_drawn_depth_too) {
  for (const int size : {48, 301, 640}) {
    Settings settings = small_scene();
    settings.image.width = size;
    settings.image.height = size - 8;
    const std::vector<Polyline> silhouettes = silhouettes_of(extract(settings).lines, 1);
    ASSERT_EQ(silhouettes.size(), 1U) << size;
    EXPECT_EQ(silhouettes[0].points.front(), silhouettes[0].points.back()) << size;
  }
}

TEST(ReferenceLines, rabbit_has_a_silhouette_all_around) {
  // Without the box, into which its tail reaches: where two objects cut each other there is none.
  for (const glm::vec3 eye : {glm::vec3(2.4F, 3.5F, 9.6F), glm::vec3(-5.0F, 2.0F, -5.0F)}) {
    Settings settings = paper_scene(512, 512);
    settings.models[1].visible = false;
    settings.camera.eye = eye;
    const Extracted extracted = extract(settings);
    EXPECT_EQ(outline_share(extracted, 1, 2), 1.0);
    EXPECT_GT(outline_share(extracted, 1, 1), 0.99);
  }
}

TEST(ReferenceLines, rabbits_lines_lie_on_the_rabbit) {
  const Extracted extracted = extract(paper_scene(512, 512));
  for (const Polyline& line : extracted.lines.polylines) {
    if (line.line_class == LineClass::object) continue;
    int away = 0;
    for (const glm::vec2& point : line.points) {
      bool is_near = false;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const int x = std::clamp(static_cast<int>(point.x) + dx, 0, 511);
          const int y = std::clamp(static_cast<int>(point.y) + dy, 0, 511);
          is_near |= std::lround(extracted.object_id.at(x, y)) == line.object_id;
        }
      }
      away += is_near ? 0 : 1;
    }
    EXPECT_EQ(away, 0) << name_of(line.line_class) << " of object " << line.object_id;
  }
}

TEST(ReferenceLines, paper_scenes_box_shows_nine_edges_and_its_room_none) {
  const ReferenceLines lines = extract(paper_scene(512, 512)).lines;
  int creases = 0;
  for (const Polyline& line : lines.polylines) {
    EXPECT_NE(line.object_id, 3) << name_of(line.line_class);
    creases += line.object_id == 2 && line.line_class == LineClass::crease ? 1 : 0;
  }
  EXPECT_EQ(creases, 3);
  double length = 0.0;
  for (const Polyline& line : silhouettes_of(lines, 2)) {
    for (size_t i = 1; i < line.points.size(); ++i)
      length += glm::length(line.points[i] - line.points[i - 1]);
  }
  EXPECT_GT(length, 350.0);  // six edges, one of them behind the rabbit's tail in part
}

TEST(ReferenceLines, rabbit_has_lines_of_every_class_it_can_have) {
  const ReferenceLines lines = extract(paper_scene(512, 512)).lines;
  for (const LineClass line_class : {LineClass::silhouette, LineClass::crease, LineClass::object,
                                     LineClass::suggestive, LineClass::ridge, LineClass::valley}) {
    EXPECT_GT(class_map(lines, line_class).count(), 100) << name_of(line_class);
  }
  EXPECT_EQ(class_map(lines, LineClass::boundary).count(), 0);
}

/// A ball with dents, `scale` times as large, in a file of its own units.
std::string dented_ball(TempFolder& folder, float scale) {
  const Mesh ball = make_sphere(48);
  std::string text;
  for (const glm::vec3& p : ball.positions) {
    const glm::vec3 place = scale * p * (1.0F + 0.2F * std::sin(5.0F * p.x) * std::sin(5.0F * p.y + 1.0F));
    text += "v " + shortest(place.x) + " " + shortest(place.y) + " " + shortest(place.z) + "\n";
  }
  for (const auto& t : ball.triangles) text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return folder.write(fmt::format("ball_{}.obj", scale), text).string();
}

TEST(ReferenceLines, of_a_scene_of_another_size_are_the_same) {
  TempFolder folder;
  for (const CameraProjection projection : {CameraProjection::perspective, CameraProjection::orthographic}) {
    Settings settings = analytic_scene();
    settings.camera.projection = projection;
    settings.models[1] = {.name = "ball", .mesh = dented_ball(folder, 1.0F), .position = {0.9F, 1.0F, 0.0F}};
    Pipeline pipeline;
    const std::vector<Polyline> before = pipeline.at(settings).value<ReferencePass>()->polylines;
    EXPECT_TRUE(std::ranges::any_of(
        before, [](const Polyline& line) { return line.line_class == LineClass::suggestive; }));
    for (const float scale : {0.0009765625F, 1024.0F}) {  // powers of two, which floats hold exactly
      Settings other = scaled_scene(settings, scale);
      other.models[1].mesh = dented_ball(folder, scale);
      other.models[1].scale = glm::vec3(1.0F);
      EXPECT_TRUE(pipeline.at(other).value<ReferencePass>()->polylines == before) << scale;
    }
  }
}

}  // namespace
}  // namespace inkbench
