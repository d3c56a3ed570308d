// SPDX-License-Identifier: MIT
// Reference lines found beside the window: the same lines as in the foreground, kept parts, stopping.
#include "app/workbench/live_reference.h"
#include "pipeline/mesh/levels/model_mesh.h"

#include <chrono>
#include <thread>

#include "pipeline/lines/drawing.h"
#include "tests/unit/reference_support.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

Key key_of(const std::string& name) {
  return KeyBuilder().add(name).key();
}

std::shared_ptr<const Mesh> sphere() {
  ModelParams model;
  model.shape = Shape::sphere;
  model.segments = 24;
  return std::make_shared<Mesh>(make_model_mesh(model));
}

/// A sphere seen from `distance`, with its buffers from the tests' own rasteriser.
LineRequest sphere_request(const std::shared_ptr<const Mesh>& mesh, float distance) {
  ReferenceScene scene;
  scene.width_px = scene.height_px = 96;
  scene.camera.eye = {0, 0, distance};
  scene.camera.target = {0, 0, 0};
  scene.add(*mesh);
  scene.rasterise();
  LineRequest request{.key = key_of("sphere from " + std::to_string(distance)), .camera = scene.camera};
  request.depth = scene.depth;
  request.object_id = scene.object_id;
  ModelParams params;
  params.size = 0;  // as it is
  params.anchor = Anchor::origin;
  request.models.push_back({.params = params,
                            .object_id = 1,
                            .full = mesh,
                            .drawn = mesh,
                            .full_key = key_of("full"),
                            .drawn_key = key_of("drawn")});
  return request;
}

std::string svg(const ReferenceLines& lines) {
  return reference_svg(lines);
}

/// What comes next; fails after 20 s.
FoundLines wait_for(LiveReference& live) {
  for (int i = 0; i < 2000; ++i) {
    if (std::optional<FoundLines> found = live.take()) return *found;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ADD_FAILURE() << "waited in vain for lines";
  return {};
}

TEST(LineFinder, finds_what_the_parts_give_and_the_same_again_from_what_it_kept) {
  const auto mesh = sphere();
  const LineRequest near = sphere_request(mesh, 3);
  const MeshTopology topology = make_topology(*mesh);
  const MeshFeatures features = make_features(topology);
  const SceneMesh whole{&topology, model_matrix(near.models[0].params, bounds_of(*mesh)), 1, &features};
  const std::string expected =
      svg(reference_lines(std::span(&whole, 1), near.camera, near.depth, near.object_id));
  EXPECT_THAT(expected, ::testing::HasSubstr("<path"));
  LineFinder finder;
  EXPECT_EQ(svg(finder.find(near)), expected);
  EXPECT_NE(svg(finder.find(sphere_request(mesh, 6))), expected) << "another view";
  EXPECT_EQ(svg(finder.find(near)), expected);
  LineRequest nothing = near;
  nothing.models.clear();
  EXPECT_EQ(class_map(finder.find(nothing), LineClass::silhouette).count(), 0U);
  EXPECT_EQ(svg(finder.find(near)), expected) << "after it was forgotten";
}

TEST(LineFinder, stops_when_asked) {
  LineFinder finder;
  EXPECT_THROW(finder.find(sphere_request(sphere(), 3), [] { return true; }), Stopped);
}

TEST(LiveReference, gives_the_lines_with_pictures_of_them) {
  const auto finder = std::make_shared<LineFinder>();
  News news;
  LiveReference live(finder, news);
  const LineRequest request = sphere_request(sphere(), 3);
  live.ask(request.key, [&] { return request; });
  const FoundLines found = wait_for(live);
  EXPECT_EQ(found.key, request.key);
  EXPECT_EQ(found.error, "");
  ASSERT_NE(found.lines, nullptr);
  EXPECT_EQ(svg(*found.lines), svg(finder->find(request)));
  EXPECT_EQ(found.picture.samples, draw_reference(*found.lines).samples);
  int inked = 0;
  for (int y = 0; y < 96; ++y) {
    for (int x = 0; x < 96; ++x) {
      const bool white = found.picture.at(x, y, 0) == 255 && found.picture.at(x, y, 1) == 255 &&
                         found.picture.at(x, y, 2) == 255;
      EXPECT_EQ(found.overlay.at(x, y, 3), white ? 0 : 255);
      inked += white ? 0 : 1;
    }
  }
  EXPECT_GT(inked, 100) << "a circle of more than 30 px across";
}

TEST(LiveReference, the_newest_of_many_requests_comes_last) {
  News news;
  LiveReference live(std::make_shared<LineFinder>(), news);
  const auto mesh = sphere();
  for (const float distance : {3.0F, 3.5F, 4.0F, 4.5F, 5.0F}) {
    const LineRequest request = sphere_request(mesh, distance);
    live.ask(request.key, [&] { return request; });
  }
  FoundLines found = wait_for(live);
  while (live.is_busy() || found.key != sphere_request(mesh, 5).key) found = wait_for(live);
  EXPECT_EQ(found.key, sphere_request(mesh, 5).key);
}

}  // namespace
}  // namespace inkbench
