// SPDX-License-Identifier: MIT
// Ladders made beside the window.
#include "app/workbench/ladder_maker.h"

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "pipeline/mesh/levels/level_normals.h"

namespace inkbench {
namespace {

ModelParams sphere_model(int segments) {
  ModelParams model;
  model.shape = Shape::sphere;
  model.segments = segments;
  return model;
}

LadderRequest ladder_request(const std::string& name, const ModelParams& model, int faces) {
  return {{KeyBuilder().add(name).key(), faces > 0}, model, {.faces = faces}};
}

/// The ladder that comes next; fails after 20 s.
std::optional<MadeLadder> wait_for_ladder(LadderMaker& maker) {
  for (int i = 0; i < 2000; ++i) {
    if (std::optional<MadeLadder> made = maker.take()) return made;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ADD_FAILURE() << "waited in vain for a ladder";
  return std::nullopt;
}

void ask(LadderMaker& maker, const LadderRequest& wanted) {
  maker.ask(wanted.name, [&] { return wanted; });
}

TEST(MeshLadder, is_ready_for_a_level_once_prepared_and_gives_its_triangles) {
  MeshLadder ladder(sphere_model(24), 0);
  EXPECT_TRUE(ladder.is_ready_for({}));
  EXPECT_TRUE(ladder.is_ready_for({.normals = LevelNormals::flat}));
  EXPECT_TRUE(ladder.is_ready_for({.faces = 1'000'000})) << "it has no more";
  EXPECT_FALSE(ladder.is_ready_for({.faces = 100}));
  ladder.prepare({.faces = 100});
  EXPECT_TRUE(ladder.is_ready_for({.faces = 50}));
  EXPECT_EQ(ladder.level({.faces = 100})->triangles.size(), 100U);
  EXPECT_EQ(ladder.level({}), ladder.full());
}

TEST(MeshLadder, stopping_leaves_it_as_it_was) {
  MeshLadder ladder(sphere_model(200), 0);
  int asked = 0;
  EXPECT_THROW(ladder.prepare({.faces = 100}, [&] { return ++asked > 3; }), Stopped);
  EXPECT_EQ(asked, 4);
  EXPECT_FALSE(ladder.is_ready_for({.faces = 100}));
}

TEST(LadderMaker, makes_what_gives_the_level_at_once) {
  News news;
  LadderMaker maker(news);
  ask(maker, ladder_request("ball", sphere_model(24), 100));
  const std::optional<MadeLadder> made = wait_for_ladder(maker);
  ASSERT_TRUE(made && made->ladder);
  EXPECT_EQ(made->name.key, KeyBuilder().add("ball").key());
  EXPECT_TRUE(made->ladder->is_ready_for({.faces = 100}));
  EXPECT_FALSE(maker.take());
}

TEST(LadderMaker, mesh_that_cannot_be_read_gives_no_ladder_and_the_next_one_works) {
  News news;
  LadderMaker maker(news);
  ModelParams missing;
  missing.shape = Shape::mesh;
  missing.mesh = "/no/such.obj";
  ask(maker, ladder_request("missing", missing, 100));
  std::optional<MadeLadder> made = wait_for_ladder(maker);
  ASSERT_TRUE(made);
  EXPECT_FALSE(made->ladder);
  ask(maker, ladder_request("ball", sphere_model(24), 0));
  made = wait_for_ladder(maker);
  ASSERT_TRUE(made && made->ladder);
  EXPECT_FALSE(made->ladder->is_ready_for({.faces = 100})) << "no record was asked for";
}

TEST(LadderMaker, newer_request_ends_the_one_in_work) {
  News news;
  LadderMaker maker(news);
  ask(maker, ladder_request("large", sphere_model(700), 100));  // seconds of work
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ask(maker, ladder_request("small", sphere_model(24), 100));
  const std::optional<MadeLadder> made = wait_for_ladder(maker);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->name.key, KeyBuilder().add("small").key());
}

}  // namespace
}  // namespace inkbench
