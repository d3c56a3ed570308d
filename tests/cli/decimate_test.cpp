// SPDX-License-Identifier: MIT
// `inkbench decimate`, and `mesh.faces` as a parameter and an axis.
#include "pipeline/mesh/formats/mesh_file.h"
#include "tests/cli/study_fixture.h"

namespace inkbench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Decimate : public StudyTest {};

TEST_F(Decimate, writes_each_level_with_its_faces) {
  const CommandResult result = inkbench({"decimate", "rabbit", "--faces", "5000,300", "--out", "levels"});
  ASSERT_TRUE(succeeds(result));
  EXPECT_THAT(result.out, HasSubstr("5000 asked, 5000 reached"));
  EXPECT_EQ(load_mesh_file(file("levels/rabbit_5000.ply")).triangles.size(), 5000U);
  EXPECT_EQ(load_mesh_file(file("levels/rabbit_300.ply")).triangles.size(), 300U);
  EXPECT_TRUE(succeeds(inkbench(
      {"decimate", "levels/rabbit_300.ply", "--faces", "100", "--format", "obj", "--out", "levels"})));
  EXPECT_LE(load_mesh_file(file("levels/rabbit_300_100.obj")).triangles.size(), 100U);
}

TEST_F(Decimate, bad_counts_and_meshes_are_named) {
  for (const char* faces : {"0", "-5", "many", "10,,20", "10,10"}) {
    EXPECT_TRUE(is_input_error(inkbench({"decimate", "rabbit", "--faces", faces, "--out", "x"}), {"--faces"}))
        << faces;
  }
  EXPECT_TRUE(is_input_error(inkbench({"decimate", "no.ply", "--faces", "10", "--out", "x"}), {"no.ply"}));
}

TEST_F(Decimate, cached_record_changes_no_byte_and_a_damaged_one_is_made_again) {
  CommandOptions options;
  options.environment["INKBENCH_CACHE"] = file("cache").string();
  const auto level = [&](const std::string& out) {
    EXPECT_TRUE(succeeds(inkbench({"decimate", "rabbit", "--faces", "2000", "--out", out}, options)));
    return content_of(file(out) / "rabbit_2000.ply");
  };
  const std::string first = level("a");
  EXPECT_EQ(level("b"), first);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(file("cache"))) {
    if (entry.is_regular_file()) fs::resize_file(entry.path(), fs::file_size(entry.path()) / 2);
  }
  EXPECT_EQ(level("c"), first);
}

TEST_F(Decimate, a_cache_that_cannot_be_written_is_a_note_and_no_error) {
  write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  CommandOptions options;
  options.environment["INKBENCH_CACHE"] = write("file", "").string();
  const CommandResult result = inkbench({"decimate", "mesh.obj", "--faces", "2", "--out", "out"}, options);
  ASSERT_TRUE(succeeds(result));
  EXPECT_THAT(result.err, HasSubstr("not kept"));
  EXPECT_EQ(load_mesh_file(file("out/mesh_2.ply")).triangles.size(), 2U);
}

TEST_F(Decimate, face_count_is_an_axis_of_a_study) {
  write("s.toml",
        "size = [96, 96]\nshow = [\"final\"]\nmeasure = [\"f1_geometry\", \"f1_end_to_end\", "
        "\"f1\"]\n[[axis]]\nkey = \"mesh.faces\"\nvalues = [0, 5000, 200]\n"
        "[[axis]]\nkey = \"mesh.normals\"\nvalues = [\"smooth\", \"nearest\"]\n");
  ASSERT_TRUE(succeeds(study("s", "a")));
  ASSERT_TRUE(succeeds(study("s", "b")));
  EXPECT_EQ(difference(lasting_content(file("a")), lasting_content(file("b"))), "same");
  EXPECT_THAT(table("a").column("mesh.faces"), ElementsAre("0", "5000", "200", "0", "5000", "200"));
  const StudyTable data = table("a");
  EXPECT_EQ(data.rows[0].at("f1_geometry"), "1") << "the full mesh against itself";
  EXPECT_EQ(data.rows[0].at("f1_end_to_end"), data.rows[0].at("f1"));
  EXPECT_LT(std::stod(data.rows[2].at("f1_geometry")), 0.99);
  EXPECT_NE(content_of(file("a/cells/0001_final.png")), content_of(file("a/cells/0003_final.png")));
}

}  // namespace
}  // namespace inkbench
