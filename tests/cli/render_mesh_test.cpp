// SPDX-License-Identifier: MIT
// `inkbench render --mesh` and the rabbit: another mesh stands where the main model stood, at the same size.
#include <sstream>

#include "pipeline/image/image_file.h"
#include "tests/cli/cli_test.h"
#include "tests/cli/written_mesh.h"

namespace inkbench {
namespace {

constexpr const char* kRabbitFile = "/usr/share/glmark2/models/bunny.obj";

class RenderMesh : public CliTest {
 protected:
  Image object_ids(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"render", "--out", "out", "--buffers", "object_id", "--format",
                                         "exr", "--size", "256x256"});
    EXPECT_TRUE(succeeds(inkbench(arguments)));
    return read_image(file("out/object_id.exr"));
  }
};

struct Extent {
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1, count = 0;
};

Extent extent_of_object(const Image& ids, float id) {
  Extent extent;
  for (int y = 0; y < ids.height_px; ++y) {
    for (int x = 0; x < ids.width_px; ++x) {
      if (ids.at(x, y) != id) continue;
      extent.left = std::min(extent.left, x);
      extent.right = std::max(extent.right, x);
      extent.top = std::min(extent.top, y);
      extent.bottom = std::max(extent.bottom, y);
      ++extent.count;
    }
  }
  return extent;
}

/// Both cover the same place but for a pixel of rounding at the outline.
void expect_same_place(const Extent& a, const Extent& b) {
  EXPECT_NEAR(a.left, b.left, 1);
  EXPECT_NEAR(a.right, b.right, 1);
  EXPECT_NEAR(a.top, b.top, 1);
  EXPECT_NEAR(a.bottom, b.bottom, 1);
  EXPECT_NEAR(a.count, b.count, 0.01 * a.count + 4);
}

/// The OBJ file's vertices times `scale` plus `offset`, all else as it is.
std::string moved_obj(const std::string& obj, double scale, double offset) {
  std::istringstream lines(obj);
  std::ostringstream result;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    double x = 0, y = 0, z = 0;
    if (words >> kind >> x >> y >> z && kind == "v") {
      result << "v " << x * scale + offset << ' ' << y * scale - offset << ' ' << z * scale + 2 * offset
             << '\n';
    } else {
      result << line << '\n';
    }
  }
  return std::move(result).str();
}

TEST_F(RenderMesh, scaled_and_moved_rabbit_stands_as_the_rabbit_does) {
  const Image expected = object_ids({});
  write("big.obj", moved_obj(content_of(kRabbitFile), 10.0, 37.0));
  const Image big = object_ids({"--mesh", "big.obj"});
  expect_same_place(extent_of_object(expected, 1), extent_of_object(big, 1));
  expect_same_place(extent_of_object(expected, 2), extent_of_object(big, 2));
}

TEST_F(RenderMesh, mesh_takes_the_place_of_a_shape_that_stands_by_its_middle) {
  write("scene.toml", small_scene());
  write("cube.off", cube_off(7.0, -3.0));
  const Image expected = object_ids({"--scene", "scene.toml"});
  const Image cube = object_ids({"--scene", "scene.toml", "--mesh", "cube.off"});
  expect_same_place(extent_of_object(expected, 1), extent_of_object(cube, 1));
}

TEST_F(RenderMesh, each_format_draws_the_same_cube) {
  write("scene.toml", small_scene());
  write("cube.off", cube_off(1.0, 0.0));
  write("cube.obj", cube_obj());
  write("cube.ply", cube_ply());
  write("cube.stl", cube_stl());
  const Image expected = object_ids({"--scene", "scene.toml", "--mesh", "cube.off"});
  for (const std::string name : {"cube.obj", "cube.ply", "cube.stl"}) {
    EXPECT_EQ(object_ids({"--scene", "scene.toml", "--mesh", name}), expected) << name;
  }
}

TEST_F(RenderMesh, relative_mesh_path_is_found_again_from_another_folder) {
  write("scene.toml", small_scene());
  write("cube.off", cube_off(1.0, 0.0));
  ASSERT_TRUE(
      succeeds(inkbench({"render", "--scene", "scene.toml", "--mesh", "cube.off", "--out", "first"})));
  fs::create_directories(file("elsewhere"));
  CommandOptions elsewhere;
  elsewhere.working_folder = file("elsewhere");
  ASSERT_TRUE(succeeds(inkbench({"render", "--from", file("first/final.png"), "--out", "again"}, elsewhere)));
  EXPECT_EQ(content_of(file("first/final.png")), content_of(file("elsewhere/again/final.png")));
}

TEST_F(RenderMesh, mesh_set_by_key_is_the_same_as_mesh_option) {
  write("cube.off", cube_off(2.0, 1.0));
  EXPECT_EQ(object_ids({"--mesh", "cube.off"}), object_ids({"--set", "model.rabbit.mesh=cube.off"}));
}

TEST_F(RenderMesh, rabbit_comes_from_the_environment) {
  write("cube.off", cube_off(1.0, 0.0));
  CommandOptions options;
  options.environment["INKBENCH_RABBIT"] = file("cube.off");
  ASSERT_TRUE(succeeds(inkbench({"render", "--out", "a", "--size", "64x64"}, options)));
  ASSERT_TRUE(
      succeeds(inkbench({"render", "--out", "b", "--size", "64x64", "--set", "model.rabbit.mesh=cube.off"})));
  EXPECT_EQ(read_picture(file("a/final.png"), 3), read_picture(file("b/final.png"), 3));
}

TEST_F(RenderMesh, rabbit_that_the_environment_names_wrongly_is_an_error) {
  CommandOptions options;
  options.environment["INKBENCH_RABBIT"] = "/nowhere/rabbit.obj";
  EXPECT_TRUE(is_input_error(inkbench({"render", "--out", "out"}, options),
                             {"INKBENCH_RABBIT", "/nowhere/rabbit.obj"}));
  EXPECT_TRUE(is_input_error(inkbench({"study", "figure_01", "--out", "out"}, options),
                             {"INKBENCH_RABBIT", "/nowhere/rabbit.obj"}));
  EXPECT_TRUE(!fs::exists(file("out")) || fs::is_empty(file("out")));
}

TEST_F(RenderMesh, scene_without_the_rabbit_does_not_need_it) {
  write("scene.toml", small_scene());
  CommandOptions options;
  options.environment["INKBENCH_RABBIT"] = "/nowhere/rabbit.obj";
  EXPECT_TRUE(succeeds(inkbench({"render", "--scene", "scene.toml", "--out", "out"}, options)));
}

TEST_F(RenderMesh, million_faces_draw_in_under_a_gibibyte) {
  write("million.ply", wave_ply(708));
  const CommandResult result =
      inkbench({"render", "--mesh", "million.ply", "--out", "out", "--size", "512x512"});
  ASSERT_TRUE(succeeds(result));
  EXPECT_LT(result.peak_memory_kb, 1024 * 1024);
  RecordProperty("peak_memory_mb", std::to_string(result.peak_memory_kb / 1024));
  RecordProperty("milliseconds", std::to_string(static_cast<int>(result.seconds * 1000)));
  std::printf("a mesh of 1,002,528 faces: %.1f s, peak %ld MB\n", result.seconds,
              result.peak_memory_kb / 1024);
}

}  // namespace
}  // namespace inkbench
