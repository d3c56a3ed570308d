// SPDX-License-Identifier: MIT
// Written meshes read back equal.
#include "pipeline/mesh/formats/mesh_write.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/shapes/primitives.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class MeshWrite : public testing::TestWithParam<MeshFileFormat> {
 protected:
  std::string name() const { return GetParam() == MeshFileFormat::ply ? "mesh.ply" : "mesh.obj"; }
};

TEST_P(MeshWrite, reads_back_equal) {
  const TemporaryFolder folder;
  for (const Mesh& mesh : {make_torus(9, 0.3F), make_box(2), make_plane(3)}) {
    write_mesh_file(mesh, folder.path() / name(), GetParam(), "a comment");
    const Mesh back = load_mesh_file(folder.path() / name());
    EXPECT_EQ(back.positions, mesh.positions);
    EXPECT_EQ(back.triangles, mesh.triangles);
    ASSERT_EQ(back.normals.size(), mesh.normals.size());
    for (size_t i = 0; i < back.normals.size(); ++i)
      EXPECT_LT(glm::distance(back.normals[i], mesh.normals[i]), 1e-6F);
    EXPECT_TRUE(back.notes.empty()) << back.notes.front();
  }
}

TEST_P(MeshWrite, keeps_small_and_large_numbers) {
  const TemporaryFolder folder;
  Mesh mesh = make_plane(1);
  for (glm::vec3& p : mesh.positions) p = p * 1.2345678e-20F + glm::vec3(0, 7.6543e18F, 0);
  mesh.positions[0].y = -7.6543e18F;
  write_mesh_file(mesh, folder.path() / name(), GetParam());
  const Mesh back = load_mesh_file(folder.path() / name());
  ASSERT_EQ(back.positions.size(), mesh.positions.size());
  for (size_t i = 0; i < back.positions.size(); ++i)
    EXPECT_EQ(back.origin.y + back.unit * back.positions[i].y, mesh.positions[i].y);
}

TEST_P(MeshWrite, writes_a_far_mesh_where_its_file_has_it) {
  const TemporaryFolder folder;
  Mesh mesh = make_box(1);
  mesh.origin = {500'000.25, -3e6, 12.5};
  write_mesh_file(mesh, folder.path() / name(), GetParam());
  const Mesh back = load_mesh_file(folder.path() / name());
  for (size_t i = 0; i < back.positions.size(); ++i) {
    const glm::dvec3 place = back.origin + back.unit * glm::dvec3(back.positions[i]);
    EXPECT_LT(glm::distance(place, mesh.origin + glm::dvec3(mesh.positions[i])), 1e-6);
  }
}

TEST_P(MeshWrite, a_folder_that_cannot_be_written_to_is_an_error) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("file", "");
  error_of([&] { write_mesh_file(make_box(1), file / name(), GetParam()); }, ErrorKind::work);
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshWrite, testing::Values(MeshFileFormat::ply, MeshFileFormat::obj),
                         [](const auto& format) {
                           return format.param == MeshFileFormat::ply ? "ply" : "obj";
                         });

TEST(MeshText, comments_stand_in_the_head) {
  EXPECT_THAT(obj_text(make_plane(1), "by hand"), StartsWith("# by hand\n"));
  EXPECT_THAT(ply_text(make_plane(1), "by hand"), HasSubstr("\ncomment by hand\n"));
}

}  // namespace
}  // namespace inkbench
