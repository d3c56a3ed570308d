// SPDX-License-Identifier: MIT
// Meshes that are no clean closed surface go through everything: decimation, reference lines, measured
// studies, scores.
#include "tests/cli/odd_meshes.h"

#include <fmt/format.h>

#include "pipeline/base/text.h"
#include "pipeline/image/image_file.h"
#include "pipeline/mesh/closed.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/shapes/primitives.h"
#include "tests/cli/study_fixture.h"

namespace inkbench {
namespace {

using testing::HasSubstr;

class OddMeshes : public StudyTest {
 protected:
  OddMeshes() {
    for (const OddMesh& odd : odd_meshes()) write(odd.name, odd.content);
  }
  CommandResult decimate(const std::string& mesh, const std::string& faces) const {
    return inkbench({"decimate", mesh, "--faces", faces, "--out", "levels"});
  }
  /// A study of meshes where the small scene's box stood, alone: two cells for each, of all faces and of 20.
  CommandResult study_of(const std::vector<std::string>& meshes, const std::string& out) const {
    write_spec(out,
               "size = [96, 72]\nshow = [\"reference\", \"combined_edges\"]\nmeasure = true\n"
               "[set]\nmodel.box.shape = \"mesh\"\nmodel.box.size = 3\nmodel.box.position = [0, 0, 0]\n"
               "model.ball.visible = false\nmodel.ground.visible = false\n"
               "[[axis]]\nkey = \"mesh.faces\"\nvalues = [0, 20]\n"
               "[[axis]]\nkey = \"model.box.mesh\"\nvalues = [\"" +
                   join(meshes, "\", \"") + "\"]\n");
    return study(out, out);
  }
  /// The cell of all faces of mesh number `mesh`.
  Picture picture(const std::string& out, size_t mesh, const std::string& buffer) const {
    return read_picture(file(fmt::format("{}/cells/{:04}_{}.png", out, 2 * mesh + 1, buffer)), 3);
  }
};

size_t pixels_that_differ(const Picture& a, const Picture& b) {
  size_t count = 0;
  for (size_t i = 0; i < a.samples.size(); i += 3)
    count += std::equal(&a.samples[i], &a.samples[i] + 3, &b.samples.at(i)) ? 0 : 1;
  return count;
}

size_t pixels_unlike_the_first(const Picture& picture) {
  size_t count = 0;
  for (size_t i = 0; i < picture.samples.size(); i += 3)
    count += std::equal(&picture.samples[i], &picture.samples[i] + 3, picture.samples.data()) ? 0 : 1;
  return count;
}

using Row = std::map<std::string, std::string>;

/// Of a mesh with all its faces and of the same with at most 20, if it comes so low.
void expect_sound(const OddMesh& odd, const Row& full, const Row& level) {
  EXPECT_EQ(std::stoul(full.at("faces")), odd.faces);
  EXPECT_EQ(full.at("f1_geometry"), "1") << "against itself";
  EXPECT_EQ(full.at("f1_end_to_end"), full.at("f1"));
  EXPECT_LE(std::stoul(level.at("faces")), odd.faces);
  EXPECT_GT(std::stoul(level.at("faces")), 0U);
  for (const Row* row : {&full, &level}) {
    for (const char* column : {"precision", "recall", "f1", "f1_geometry", "f1_end_to_end"}) {
      const double value = std::stod(row->at(column));
      EXPECT_TRUE(value > 0 && value <= 1) << column << " " << value;
    }
  }
}

TEST_F(OddMeshes, decimate_to_levels_that_load_again) {
  for (const OddMesh& odd : odd_meshes()) {
    SCOPED_TRACE(odd.name);
    const CommandResult result = decimate(odd.name, "100,20");
    EXPECT_TRUE(succeeds(result));
    EXPECT_THAT(result.err, HasSubstr(odd.note));
    EXPECT_EQ(result.err.empty(), odd.note.empty()) << result.err;
    for (const size_t asked : {100, 20}) {
      const Mesh level =
          load_mesh_file(file(fmt::format("levels/{}_{}.ply", fs::path(odd.name).stem().string(), asked)));
      const bool ends_above =
          result.out.find(fmt::format("{} asked, {} reached (decimation ends there)", asked,
                                      level.triangles.size())) != std::string::npos;
      EXPECT_TRUE(level.triangles.size() <= std::min(asked, odd.faces) || ends_above) << result.out;
    }
  }
}

TEST_F(OddMeshes, an_stl_rounded_facet_by_facet_stays_closed_when_it_is_decimated) {
  ASSERT_TRUE(succeeds(decimate("rounded.stl", "100")));
  const Mesh level = load_mesh_file(file("levels/rounded_100.ply"));
  EXPECT_EQ(level.triangles.size(), 100U);
  EXPECT_TRUE(is_closed_outwards(level));
}

TEST_F(OddMeshes, reference_lines_do_not_depend_on_sides_seams_and_repetitions) {
  write("torus.obj", obj_of(make_torus(16, 0.35F)));
  write("box.obj", obj_of(make_box(4)));
  ASSERT_TRUE(succeeds(study_of(
      {"torus.obj", "rounded.stl", "inside_out.obj", "doubled.obj", "box.obj", "nan.obj", "flat.obj"},
      "out")));
  const auto difference = [&](size_t clean, size_t odd) {
    return pixels_that_differ(picture("out", clean, "reference"), picture("out", odd, "reference"));
  };
  EXPECT_LE(difference(0, 1), 20U) << "a corner that moved by a float's step may fall into the next pixel";
  EXPECT_EQ(difference(0, 2), 0U);
  EXPECT_EQ(difference(0, 3), 0U);
  EXPECT_EQ(difference(4, 5), 0U);
  EXPECT_EQ(difference(4, 6), 0U);
}

TEST_F(OddMeshes, are_drawn_measured_and_scored) {
  const std::vector<OddMesh> all = odd_meshes();
  std::vector<std::string> names;
  for (const OddMesh& odd : all) names.push_back(odd.name);
  ASSERT_TRUE(succeeds(study_of(names, "out")));
  const StudyTable data = table("out");
  ASSERT_EQ(data.rows.size(), 2 * all.size());
  for (size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(all[i].name);
    expect_sound(all[i], data.rows[2 * i], data.rows[2 * i + 1]);
    EXPECT_GT(pixels_unlike_the_first(picture("out", i, "reference")), 30U);
    const std::string drawn = fmt::format("out/cells/{:04}_combined_edges.png", 2 * i + 1);
    const CommandResult score = inkbench({"score", drawn, drawn, "--json"});
    EXPECT_TRUE(succeeds(score));
    EXPECT_THAT(score.out, HasSubstr("\"f1\": 1,"));
  }
  EXPECT_NE(data.rows[0].at("recall_boundary"), "") << "a bowl has a rim";
  EXPECT_EQ(data.rows[8].at("recall_boundary"), "") << "a closed STL has none, however it was rounded";
}

TEST_F(OddMeshes, without_a_face_to_draw_are_an_error_everywhere) {
  std::vector<std::string> names{"one.obj"};
  for (const OddMesh& odd : hopeless_meshes()) {
    write(odd.name, odd.content);
    names.push_back(odd.name);
    EXPECT_TRUE(is_input_error(decimate(odd.name, "10"), {odd.name, "no face can be drawn", odd.note}));
    EXPECT_FALSE(fs::exists(file("levels")));
  }
  EXPECT_TRUE(
      is_input_error(inkbench({"render", "--mesh", names.back(), "--buffers", "reference", "--out", "out"}),
                     {names.back()}));
  EXPECT_TRUE(!fs::exists(file("out")) || fs::is_empty(file("out")));
  const CommandResult result = study_of(names, "study");
  EXPECT_NE(result.status, 0);
  EXPECT_EQ(result.signal, 0);
  EXPECT_THAT(result.err, HasSubstr(names[1]));
}

}  // namespace
}  // namespace inkbench
