// SPDX-License-Identifier: MIT
// Other programs' files on the command line: as one mesh, part by part, and as a scene.
#include <sys/stat.h>

#include <set>

#include "pipeline/image/image_file.h"
#include "tests/cli/cli_test.h"
#include "tests/written_gltf.h"

namespace inkbench {
namespace {

using testing::HasSubstr;

class ImportedFiles : public CliTest {
 protected:
  ImportedFiles() {
    write("scene.toml", small_scene());
    write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    write_gltf(file("."), {.nodes = R"({"name": "near", "mesh": 0},
                                       {"name": "far", "mesh": 0, "translation": [2, 0, -1]})",
                           .scene_nodes = "0, 1"});
  }

  Image object_ids(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"render", "--out", "out", "--buffers", "object_id", "--format",
                                         "exr", "--size", "96x64"});
    EXPECT_TRUE(succeeds(inkbench(arguments)));
    return read_image(file("out/object_id.exr"));
  }
  Picture drawn(std::vector<std::string> arguments, const std::string& out) const {
    arguments.insert(arguments.begin(), {"render", "--out", out, "--size", "96x64"});
    EXPECT_TRUE(succeeds(inkbench(arguments)));
    return read_picture(file(out + "/final.png"), 3);
  }
};

std::set<float> ids_in(const Image& ids) {
  return {ids.samples.begin(), ids.samples.end()};
}

TEST_F(ImportedFiles, a_part_is_drawn_as_the_same_mesh_in_another_format) {
  const Image expected = object_ids({"--scene", "scene.toml", "--mesh", "square.obj"});
  EXPECT_EQ(object_ids({"--scene", "scene.toml", "--mesh", "square.gltf", "--set", "model.box.part=near"}),
            expected);
  EXPECT_NE(object_ids({"--scene", "scene.toml", "--mesh", "square.gltf"}), expected) << "both parts";
}

TEST_F(ImportedFiles, a_scene_has_a_model_for_each_part_and_sees_them_all) {
  EXPECT_EQ(ids_in(object_ids({"--scene", "square.gltf"})), (std::set<float>{0, 1, 2}));
  EXPECT_EQ(ids_in(object_ids({"--scene", "square.gltf", "--set", "model.far.visible=false"})),
            (std::set<float>{0, 1}));
}

TEST_F(ImportedFiles, a_picture_of_a_scene_is_made_again_from_what_it_carries) {
  const Picture first = drawn({"--scene", "square.gltf"}, "first");
  EXPECT_EQ(drawn({"--from", "first/final.png"}, "second"), first);
}

TEST_F(ImportedFiles, a_study_takes_a_scene_of_another_program) {
  write("study.toml",
        "scene = \"square.gltf\"\nsize = [48, 32]\n[[axis]]\nkey = \"model.near.part\"\n"
        "values = [\"near\", \"far\"]\n");
  EXPECT_TRUE(succeeds(inkbench({"study", "study.toml", "--out", "study"})));
  EXPECT_TRUE(fs::exists(file("study/grid.png")));
}

TEST_F(ImportedFiles, what_is_wrong_is_told_with_the_file) {
  write("bad.glb", "glTF but no more");
  EXPECT_TRUE(is_input_error(inkbench({"render", "--scene", "bad.glb", "--out", "out"}),
                             {"bad.glb", "cannot be read"}));
  EXPECT_TRUE(is_input_error(inkbench({"render", "--mesh", "none.fbx", "--out", "out"}),
                             {"none.fbx", "no such file"}));
  EXPECT_TRUE(is_input_error(
      inkbench({"render", "--scene", "square.gltf", "--out", "out", "--set", "model.near.part=wheel"}),
      {"square.gltf", "no part 'wheel'", "near, far"}));
}

TEST_F(ImportedFiles, a_pipe_is_no_mesh) {
  ASSERT_EQ(mkfifo(file("pipe.obj").c_str(), 0600), 0);
  for (const std::string name : {"pipe.obj", "/dev/null"})
    EXPECT_TRUE(is_input_error(inkbench({"render", "--mesh", name, "--out", "out"}), {name}));
}

}  // namespace
}  // namespace inkbench
