// SPDX-License-Identifier: MIT
// One cube as other people's files write it: by their formats' freedoms, with hard normals, inside out, far
// away, tiny. Each gives the drawing and the score of the plain one.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tests/cli/cli_test.h"

namespace inkbench {
namespace {

using testing::HasSubstr;

constexpr const char* kScene = R"([camera]
eye = [2.2, 2.4, 5.2]
target = [0, 0, 0]
[[model]]
name = "m"
shape = "mesh"
mesh = "rabbit"
size = 2.4
anchor = "base"
position = [0, -1, 0]
[[light]]
name = "key"
type = "directional"
direction = [0.55, 0.75, 0.65]
)";

/// Corner i's coordinates, 0 or 1, are its bits; faces counter-clockwise from outside.
constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                              {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
constexpr const char* kNormals = "vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 0 1 0\nvn -1 0 0\nvn 1 0 0\n";

std::string points(double scale = 1.0, double offset = 0.0, const std::string& word = "v ") {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += fmt::format("{}{} {} {}\n", word, offset + scale * (i & 1), offset + scale * (i >> 1 & 1),
                        offset + scale * (i >> 2));
  return text;
}

std::string obj(bool with_normals, bool inside_out = false) {
  std::string text = points() + (with_normals ? kNormals : "");
  for (int face = 0; face < 6; ++face) {
    text += "f";
    for (int i = 0; i < 4; ++i) {
      const int corner = kFaces[face][inside_out ? 3 - i : i] + 1;
      text += with_normals ? fmt::format(" {}//{}", corner, face + 1) : fmt::format(" {}", corner);
    }
    text += "\n";
  }
  return text;
}

std::string off(const std::string& head, double scale, double offset) {
  std::string text = head + points(scale, offset, "");
  for (const auto& face : kFaces) text += fmt::format("4 {} {} {} {}\n", face[0], face[1], face[2], face[3]);
  return text;
}

class RealFiles : public CliTest {
 protected:
  RealFiles() { write("scene.toml", kScene); }

  CommandResult measure(const std::string& mesh, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> options{"measure", "--scene", "scene.toml", "--mesh",
                                     mesh,      "--json",  "--size",     "256x256"};
    options.insert(options.end(), more.begin(), more.end());
    return inkbench(options);
  }
};

TEST_F(RealFiles, a_cube_is_a_cube_however_it_is_written) {
  write("plain.obj", obj(false));
  const CommandResult plain = measure("plain.obj");
  ASSERT_TRUE(succeeds(plain));
  EXPECT_GT(nlohmann::json::parse(plain.out).at("f1"), 0.98) << "its inner edges are drawn";
  std::string returns = obj(false);
  std::replace(returns.begin(), returns.end(), '\n', '\r');
  std::string ungrouped = obj(false);
  ungrouped.insert(ungrouped.find("f "), "s off\n");
  const std::vector<std::pair<std::string, std::string>> others{
      {"hard.obj", obj(true)},
      {"inside_out_with_normals.obj", obj(true, true)},
      {"inside_out.obj", obj(false, true)},
      {"returns.obj", returns},
      {"ungrouped.obj", ungrouped},
      {"modelnet.off", off("OFF8 6 0\n", 1.0, 0.0)},
      {"far.off", off("off\n8 6 0\n", 1.0, 500'000.0)},
      {"tiny.off", off("8 6 0\n", 1e-20, 0.0)},
      {"huge.off", off("OFF 8 6 12\n", 1e20, 0.0)}};
  for (const auto& [name, content] : others) {
    write(name, content);
    const CommandResult result = measure(name);
    ASSERT_TRUE(succeeds(result)) << name;
    // Other units round pixels at the edges another way.
    const nlohmann::json numbers = nlohmann::json::parse(result.out);
    for (const char* key : {"f1", "ink", "recall_crease", "recall_silhouette"})
      EXPECT_NEAR(numbers.at(key), nlohmann::json::parse(plain.out).at(key), 0.002) << name << " " << key;
  }
}

TEST_F(RealFiles, smooth_takes_the_inner_edges_away) {
  write("plain.obj", obj(false));
  const CommandResult smooth = measure("plain.obj", {"--set", "model.m.normals=smooth"});
  ASSERT_TRUE(succeeds(smooth));
  const double sharp = nlohmann::json::parse(measure("plain.obj").out).at("recall_crease");
  EXPECT_LT(nlohmann::json::parse(smooth.out).at("recall_crease"), sharp - 0.05);
}

TEST_F(RealFiles, a_level_of_a_decimated_part_stays_sharp) {
  write("plain.obj", obj(true));
  ASSERT_TRUE(succeeds(inkbench({"decimate", "plain.obj", "--faces", "12", "--out", "levels"})));
  write("scene.toml", kScene);
  const CommandResult level = measure("levels/plain_12.ply");
  ASSERT_TRUE(succeeds(level));
  EXPECT_GT(nlohmann::json::parse(level.out).at("f1"), 0.98);
}

TEST_F(RealFiles, a_model_beyond_the_far_plane_is_told) {
  write("plain.obj", obj(false));
  const CommandResult result = measure("plain.obj", {"--set", "camera.far=1"});
  EXPECT_THAT(result.err, HasSubstr("model 'm' lies beyond the far plane"));
  write("far.off", off("OFF 8 6 0\n", 1.0, 500'000.0));  // behind the camera, in units of its own
  EXPECT_THAT(measure("far.off", {"--set", "model.m.size=0", "--set", "model.m.anchor=origin"}).err,
              HasSubstr("model 'm' lies beyond the far plane"));
}

}  // namespace
}  // namespace inkbench
