// SPDX-License-Identifier: MIT
// Meshes that are broken: what cannot be drawn is a clear error, what can be drawn is drawn and the rest is
// noted.
#include "pipeline/image/image_file.h"
#include "tests/cli/cli_test.h"
#include "tests/cli/written_mesh.h"

namespace inkbench {
namespace {

using testing::HasSubstr;

class BadMesh : public CliTest {
 protected:
  CommandResult render(const std::string& mesh) const {
    return inkbench({"render", "--mesh", mesh, "--out", "out", "--size", "32x32"});
  }
  /// Expects exit status 2, a message with the file and the words, and no image.
  void expect_refused(const std::string& name, const std::string& content,
                      std::vector<std::string> words = {}) const {
    write(name, content);
    words.push_back(name);
    fs::remove_all(file("out"));
    EXPECT_TRUE(is_input_error(render(name), words));
    EXPECT_TRUE(!fs::exists(file("out")) || fs::is_empty(file("out"))) << name;
  }
  /// Expects that the rest is drawn and the note says what was dropped.
  void expect_noted(const std::string& name, const std::string& content, const std::string& note) const {
    write(name, content);
    const CommandResult result = render(name);
    EXPECT_TRUE(succeeds(result));
    EXPECT_THAT(result.err, HasSubstr(note));
    EXPECT_TRUE(fs::exists(file("out/final.png")));
  }
};

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST_F(BadMesh, missing_file_is_named) {
  EXPECT_TRUE(is_input_error(render("none.obj"), {"none.obj", "no such file"}));
}

TEST_F(BadMesh, folder_is_not_a_mesh) {
  fs::create_directories(file("folder.obj"));
  EXPECT_TRUE(is_input_error(render("folder.obj"), {"folder.obj", "folder"}));
}

TEST_F(BadMesh, unknown_extension_names_the_formats) {
  expect_refused("cube.max", "whatever", {".max", ".obj", ".ply", ".off", ".stl", ".gltf", ".fbx"});
  expect_refused("cube", cube_obj(), {".obj", ".ply", ".off", ".stl"});
}

TEST_F(BadMesh, empty_file_is_refused) {
  for (const std::string extension : {".obj", ".ply", ".off", ".stl"})
    expect_refused("empty" + extension, "", {"is empty"});
}

TEST_F(BadMesh, binary_junk_is_refused) {
  for (const std::string extension : {".obj", ".ply", ".off", ".stl"})
    expect_refused("junk" + extension, junk(5000));
}

TEST_F(BadMesh, truncated_file_is_refused) {
  const std::string off = cube_off(1, 0);
  const std::string wave = wave_ply(20);
  expect_refused("cut.off", off.substr(0, off.size() * 2 / 3));
  expect_refused("cut.ply", cube_ply().substr(0, cube_ply().size() * 2 / 3));
  expect_refused("cut_binary.ply", wave.substr(0, wave.size() / 2));
  expect_refused("cut_header.ply", wave.substr(0, 60));
  expect_refused("cut.stl", cube_stl().substr(0, 200));
  expect_refused("cut.obj", cube_obj().substr(0, 90), {"face"});
}

TEST_F(BadMesh, mesh_without_faces_is_refused) {
  expect_refused("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", {"face"});
  expect_refused("points.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", {"face"});
}

TEST_F(BadMesh, coordinates_that_are_no_numbers_drop_their_faces) {
  for (const std::string word : {"nan", "inf", "-inf"}) {
    expect_refused("all.obj", "v " + word + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect_noted("some.obj", std::string(kTriangle) + "v " + word + " 0 0\nf 2 3 4\n", "NaN");
  }
}

TEST_F(BadMesh, indices_out_of_range_drop_their_faces) {
  expect_refused("all.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  expect_noted("some.obj", std::string(kTriangle) + "f 1 2 99\n", "index");
  expect_noted("some.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 7\n", "index");
}

TEST_F(BadMesh, degenerate_triangles_are_dropped) {
  expect_refused("all.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  expect_noted("some.obj", std::string(kTriangle) + "v 2 0 0\nf 1 2 4\n", "area");
}

TEST_F(BadMesh, isolated_vertices_neither_draw_nor_change_the_size) {
  expect_noted("isolated.obj", std::string(kTriangle) + "v 500 500 500\n", "isolated");
  const Picture with = read_picture(file("out/final.png"), 3);
  write("plain.obj", kTriangle);
  ASSERT_TRUE(succeeds(render("plain.obj")));
  EXPECT_EQ(read_picture(file("out/final.png"), 3), with);
}

TEST_F(BadMesh, non_manifold_edges_are_drawn) {
  expect_noted("fan.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n",
               "non-manifold");
}

TEST_F(BadMesh, scene_that_names_a_missing_mesh_says_where) {
  write("scene.toml", small_scene() + "[[model]]\nname = \"lost\"\nmesh = \"lost.ply\"\n");
  EXPECT_TRUE(is_input_error(inkbench({"render", "--scene", "scene.toml", "--out", "out"}),
                             {"lost.ply", "no such file"}));
  write("study.toml", "scene = \"scene.toml\"\n");
  EXPECT_TRUE(
      is_input_error(inkbench({"study", "study.toml", "--out", "out"}), {"model.lost.mesh", "lost.ply"}));
}

}  // namespace
}  // namespace inkbench
