// SPDX-License-Identifier: MIT
// Mesh files, good and bad, through the whole loader: every defect is named, nothing crashes or hangs.
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/weld.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <set>

#include "pipeline/base/error.h"
#include "pipeline/base/scratch_folder.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kTetrahedronObj =
    "v 0 0 0\n"
    "v 1 0 0\n"
    "v 0 1 0\n"
    "v 0 0 1\n"
    "f 1 3 2\n"
    "f 1 2 4\n"
    "f 1 4 3\n"
    "f 2 3 4\n";

const std::string kTetrahedronPly =
    "ply\nformat ascii 1.0\ncomment element vertex nonsense\nelement vertex 4\n"
    "property float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

const std::string kTetrahedronOff =
    "OFF\n# a comment\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1 255 0 0\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

class MeshFile : public ::testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& content) {
    std::ofstream(folder_.path() / name, std::ios::binary) << content;
    return folder_.path() / name;
  }
  Mesh load(const std::string& name, const std::string& content, const MeshOptions& options = {}) {
    return load_mesh_file(write(name, content), options);
  }

  /// The message of the input error that loading ends in.
  static std::string failure(const fs::path& path) {
    try {
      load_mesh_file(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
      return error.what();
    }
    ADD_FAILURE() << path << " was loaded";
    return "";
  }
  std::string failure_of(const std::string& name, const std::string& content) {
    return failure(write(name, content));
  }

  ScratchFolder folder_;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

template <class T>
std::string raw_bytes(std::initializer_list<T> values) {
  std::string bytes;
  for (const T value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
  return bytes;
}

double volume_of(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += glm::dot(glm::dvec3(mesh.positions[a]),
                    glm::cross(glm::dvec3(mesh.positions[b]), glm::dvec3(mesh.positions[c])));
  }
  return sum / 6.0;
}

void expect_tetrahedron(const Mesh& mesh) {
  const std::vector<uint32_t> first = first_at_same_position(mesh.positions);
  EXPECT_EQ(std::set<uint32_t>(first.begin(), first.end()).size(), 4U);
  EXPECT_EQ(mesh.normals.size(), 12U) << "sharp at all edges";
  EXPECT_EQ(mesh.triangles.size(), 4U);
  EXPECT_NEAR(volume_of(mesh), 1.0 / 6.0, 1e-12);
}

/// Four corners of a tetrahedron, facet by facet.
const float kFacets[4][9] = {{0, 0, 0, 0, 1, 0, 1, 0, 0},
                             {0, 0, 0, 1, 0, 0, 0, 0, 1},
                             {0, 0, 0, 0, 0, 1, 0, 1, 0},
                             {1, 0, 0, 0, 1, 0, 0, 0, 1}};

std::string ascii_stl() {
  std::ostringstream text;
  text << "solid outer shell\n";
  for (const auto& facet : kFacets) {
    text << " facet normal 0 0 0\n  outer loop\n";
    for (int i = 0; i < 9; i += 3) {
      text << "   vertex " << facet[i] << ' ' << facet[i + 1] << ' ' << facet[i + 2] << "\n";
    }
    text << "  endloop\n endfacet\n";
  }
  return text.str() + "endsolid outer shell\n";
}

std::string binary_stl(const std::string& header = "") {
  std::string bytes = header;
  bytes.resize(80);
  bytes += raw_bytes<uint32_t>({4});
  for (const auto& facet : kFacets) {
    bytes += raw_bytes<float>({0, 0, 0});
    bytes.append(reinterpret_cast<const char*>(facet), 36);
    bytes += raw_bytes<uint16_t>({0});
  }
  return bytes;
}

std::string binary_ply(bool big_endian) {
  const auto swapped = [&](std::string bytes) {
    return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
  };
  std::string text =
      std::string("ply\nformat ") + (big_endian ? "binary_big_endian" : "binary_little_endian") +
      " 1.0\nobj_info element face 3\nelement vertex 4\nproperty double x\nproperty uchar quality\n"
      "property float y\nproperty float z\nelement face 4\nproperty list uchar float texcoord\n"
      "property list uint ushort vertex_index\nend_header\n";
  for (const auto& [x, y, z] : {std::array{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    text += swapped(raw_bytes<double>({static_cast<double>(x)})) + "q";
    text += swapped(raw_bytes<float>({static_cast<float>(y)})) +
            swapped(raw_bytes<float>({static_cast<float>(z)}));
  }
  for (const auto& [a, b, c] : {std::array<uint16_t, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    text += "\x02" + raw_bytes<float>({0.5F, 0.5F}) + swapped(raw_bytes<uint32_t>({3}));
    for (const uint16_t index : {a, b, c}) text += swapped(raw_bytes<uint16_t>({index}));
  }
  return text;
}

TEST_F(MeshFile, rabbit_has_its_known_counts_and_is_whole) {
  const Mesh mesh = load_mesh_file(find_rabbit(), {.smooth_below_deg = 180.0});
  EXPECT_EQ(mesh.positions.size(), 34'835U);
  EXPECT_EQ(mesh.triangles.size(), 69'666U);
  EXPECT_THAT(mesh.notes, ::testing::IsEmpty());
  for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0F, 1e-5F);
  EXPECT_GT(volume_of(mesh), 0.0);
}

TEST_F(MeshFile, rabbit_is_found_by_variable_and_its_absence_names_the_remedy) {
  const fs::path path = write("mine.obj", kTetrahedronObj);
  const char* before = std::getenv("INKBENCH_RABBIT");
  const std::string kept = before == nullptr ? "" : before;
  setenv("INKBENCH_RABBIT", path.c_str(), 1);
  EXPECT_EQ(find_rabbit(), path);
  setenv("INKBENCH_RABBIT", "/nowhere/bunny.obj", 1);
  try {
    find_rabbit();
    ADD_FAILURE() << "a missing file was accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("INKBENCH_RABBIT: no such file: /nowhere/bunny.obj"));
  }
  kept.empty() ? unsetenv("INKBENCH_RABBIT") : setenv("INKBENCH_RABBIT", kept.c_str(), 1);
}

TEST_F(MeshFile, every_format_yields_the_same_tetrahedron) {
  const std::map<std::string, std::string> files{{"t.obj", kTetrahedronObj},
                                                 {"UPPER.OBJ", kTetrahedronObj},
                                                 {"t.ply", kTetrahedronPly},
                                                 {"t.off", kTetrahedronOff},
                                                 {"ascii.stl", ascii_stl()},
                                                 {"binary.stl", binary_stl()},
                                                 {"solid.stl", binary_stl("solid facet vertex")},
                                                 {"little.ply", binary_ply(false)},
                                                 {"big.ply", binary_ply(true)}};
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    const Mesh mesh = load(name, content);
    expect_tetrahedron(mesh);
    EXPECT_THAT(mesh.notes, ::testing::IsEmpty());
  }
}

TEST_F(MeshFile, windows_line_ends_and_byte_order_mark_do_not_matter) {
  std::string text;
  for (const char c : kTetrahedronObj) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_tetrahedron(load("dos.obj", "\xEF\xBB\xBF" + text));
  text.clear();
  for (const char c : kTetrahedronPly) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_tetrahedron(load("dos.ply", text));
}

TEST_F(MeshFile, stl_corners_at_one_place_become_one_vertex_with_a_smooth_normal) {
  for (const std::string& content : {ascii_stl(), binary_stl()}) {
    const Mesh mesh = load("t.stl", content, {.smooth_below_deg = 180.0});
    ASSERT_EQ(mesh.positions.size(), 4U);
    for (size_t i = 0; i < 4; ++i) {
      if (mesh.positions[i] != glm::vec3(0)) continue;
      EXPECT_NEAR(glm::length(mesh.normals[i] + glm::normalize(glm::vec3(1))), 0.0F, 1e-6F);
    }
  }
}

TEST_F(MeshFile, obj_polygons_are_triangulated) {
  const Mesh mesh = load("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv -1 0.5 0\nf 1 2 3 4 5\n");
  EXPECT_EQ(mesh.triangles.size(), 3U);
  for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST_F(MeshFile, obj_negative_indices_count_back_from_the_face) {
  const Mesh mesh =
      load("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf -3 -2 -1\n");
  ASSERT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.positions[mesh.triangles[0][0]], glm::vec3(0, 0, 0));
  EXPECT_EQ(mesh.positions[mesh.triangles[1][0]], glm::vec3(5, 0, 0));
}

TEST_F(MeshFile, obj_faces_with_texture_indices_and_continued_lines_are_read) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0\nvt bad\nmtllib none.mtl\nusemtl none\n";
  EXPECT_EQ(load("t.obj", points + "f 1/1 2/1 3/1 # a comment\n").triangles.size(), 1U);
  EXPECT_EQ(load("t.obj", points + "f 1/ 2/1/ 3//\n").triangles.size(), 1U);
  EXPECT_EQ(load("t.obj", points + "f 1 2 \\\n 3\n").triangles.size(), 1U);
}

TEST_F(MeshFile, file_normals_are_kept_at_unit_length) {
  const std::string normals = "vn 0 0 2\nvn 0 3 0\nvn 0 0 1\n";
  const Mesh obj = load("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + normals + "f 1//1 2/7/2 3//-1\n");
  EXPECT_THAT(obj.normals,
              ::testing::ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)));
  EXPECT_THAT(obj.notes, IsEmpty());
  const Mesh off = load("n.off", "NOFF\n3 1 0\n0 0 0 0 0 2\n1 0 0 0 3 0\n0 1 0 0 0 1\n3 0 1 2\n");
  EXPECT_EQ(off.normals, obj.normals);
  const Mesh ply =
      load("n.ply",
           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
           "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nelement face 1\n"
           "property list uchar int vertex_indices\nend_header\n"
           "0 0 0 0 0 2 9\n1 0 0 0 3 0 9\n0 1 0 0 0 1 9\n3 0 1 2\n");
  EXPECT_EQ(ply.normals, obj.normals);
}

TEST_F(MeshFile, normals_are_computed_at_the_corners_where_the_file_has_no_usable_one) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 1 0\nvn 0 0 0\nvn nan 0 1\n";
  const std::string note = "Computed the normals of 1 corner for which the file has none that is usable.";
  for (const std::string face :
       {"f 1//1 2//1 3\n", "f 1//1 2//1 3//2\n", "f 1//1 2//1 3//3\n", "f 1//1 2//1 3//99\n"}) {
    SCOPED_TRACE(face);
    const Mesh mesh = load("n.obj", points + face);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, 1));
    EXPECT_THAT(mesh.notes, ::testing::ElementsAre(note));
  }
}

TEST_F(MeshFile, missing_folder_empty_and_unknown_files_are_named) {
  EXPECT_THAT(failure(folder_.path() / "none.obj"), HasSubstr("none.obj: no such file"));
  fs::create_directory(folder_.path() / "folder.obj");
  EXPECT_THAT(failure(folder_.path() / "folder.obj"), HasSubstr("is a folder"));
  for (const std::string name : {"e.obj", "e.ply", "e.off", "e.stl"}) {
    EXPECT_THAT(failure_of(name, ""), HasSubstr(name + ": is empty"));
  }
  EXPECT_THAT(failure_of("m.max", "x"),
              HasSubstr("unknown mesh format '.max'; known formats are .obj, .ply"));
}

TEST_F(MeshFile, content_of_another_format_is_refused) {
  EXPECT_THAT(failure_of("t.ply", kTetrahedronObj), HasSubstr("not a PLY file"));
  EXPECT_THAT(failure_of("t.off", kTetrahedronPly), HasSubstr("not an OFF file"));
  EXPECT_THAT(failure_of("t.obj", kTetrahedronPly), HasSubstr("not an OBJ file"));
  EXPECT_THAT(failure_of("b.obj", binary_stl()), HasSubstr("is binary, not an OBJ file"));
  EXPECT_THAT(failure_of("t.stl", kTetrahedronOff), HasSubstr("neither ASCII nor binary STL"));
}

TEST_F(MeshFile, random_bytes_are_refused_in_every_format) {
  std::string noise;
  uint32_t state = 1;
  for (int i = 0; i < 5000; ++i) noise += static_cast<char>((state = state * 1664525U + 1013904223U) >> 24);
  for (const std::string extension : {".obj", ".ply", ".off", ".stl"}) {
    EXPECT_THAT(failure_of("noise" + extension, noise), Not(IsEmpty())) << extension;
  }
}

TEST_F(MeshFile, truncated_ply_names_announced_and_found_counts) {
  const std::string announced = "truncated: the header announces 4 vertices and 4 faces, but the file holds ";
  EXPECT_THAT(failure_of("t.ply", replaced(kTetrahedronPly, "3 0 3 2\n3 1 2 3\n", "3 0 3")),
              HasSubstr(announced + "4 and 2"));
  EXPECT_THAT(failure_of("t.ply", replaced(kTetrahedronPly, "3 0 3 2\n3 1 2 3\n", "")),
              HasSubstr(announced + "4 and 2"));
  const std::string body = "0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  EXPECT_THAT(failure_of("t.ply", replaced(kTetrahedronPly, body, "0 0")), HasSubstr(announced + "3 and 0"));
  for (const bool big_endian : {false, true}) {
    const std::string whole = binary_ply(big_endian);
    EXPECT_THAT(failure_of("t.ply", whole.substr(0, whole.size() - 1)), HasSubstr(announced + "4 and 3"));
  }
  EXPECT_THAT(failure_of("t.ply", replaced(kTetrahedronPly, "vertex 4", "vertex 34835")),
              HasSubstr("announces 34,835 vertices and 4 faces, but the file holds"));
}

TEST_F(MeshFile, truncated_off_names_announced_and_found_counts) {
  EXPECT_THAT(failure_of("t.off", replaced(kTetrahedronOff, "3 1 2 3\n", "")),
              HasSubstr("announces 4 vertices and 4 faces, but the file holds 4 and 3"));
  EXPECT_THAT(failure_of("t.off", replaced(kTetrahedronOff, "3 1 2 3\n", "3 1 2")),
              HasSubstr("t.off:11: a face has 2 of its 3 corners"));
}

TEST_F(MeshFile, text_in_utf_16_is_refused_for_that) {
  EXPECT_THAT(failure_of("t.obj", std::string("\xFF\xFEv\0 \0", 6)), HasSubstr("is text in UTF-16"));
}

TEST_F(MeshFile, a_part_of_a_file_without_parts_is_refused) {
  try {
    load_mesh_file(write("t.obj", kTetrahedronObj), {}, "wheel");
    ADD_FAILURE() << "loaded";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("t.obj: has no parts, so none is 'wheel'"));
  }
}

TEST_F(MeshFile, truncated_stl_is_refused) {
  EXPECT_THAT(failure_of("t.stl", binary_stl().substr(0, 84 + 130)),
              HasSubstr("announces 12 vertices and 4 faces, but the file holds 6 and 2"));
  const std::string text = ascii_stl();
  EXPECT_THAT(failure_of("t.stl", text.substr(0, text.find("endsolid"))),
              HasSubstr("truncated: no 'endsolid' after 4 facets"));
  EXPECT_THAT(failure_of("t.stl", text.substr(0, text.rfind("   vertex"))),
              HasSubstr("2 of its 3 'vertex' lines"));
}

TEST_F(MeshFile, truncated_obj_names_the_broken_last_line) {
  EXPECT_THAT(failure_of("t.obj", kTetrahedronObj + "f 1 2"),
              HasSubstr("t.obj:9: truncated: the last face has 2 corners"));
  EXPECT_THAT(failure_of("t.obj", kTetrahedronObj + "v 1 2\n\n"),
              HasSubstr("t.obj:9: a vertex has 2 of its 3 numbers"));
}

TEST_F(MeshFile, numbers_that_are_none_are_named_with_their_line) {
  EXPECT_THAT(failure_of("t.obj", replaced(kTetrahedronObj, "v 0 1 0", "v 0 one 0")),
              HasSubstr("t.obj:3: 'one' is not a number"));
  EXPECT_THAT(failure_of("t.obj", replaced(kTetrahedronObj, "f 1 2 4", "f 1 x 4")),
              HasSubstr("t.obj:6: 'x' is not a face corner"));
  EXPECT_THAT(failure_of("t.ply", replaced(kTetrahedronPly, "0 1 0", "0 1,5 0")),
              HasSubstr("t.ply:13: '1,5' is not a number"));
  EXPECT_THAT(failure_of("t.ply", replaced(kTetrahedronPly, "3 0 2 1", "3 0 2.5 1")),
              HasSubstr("'2.5' is not a number"));
  EXPECT_THAT(failure_of("t.off", replaced(kTetrahedronOff, "0 1 0", "0 x 0")),
              HasSubstr("t.off:6: 'x' is not a number"));
  EXPECT_THAT(failure_of("t.stl", replaced(ascii_stl(), "vertex 0 1 0", "vertex 0 x 0")),
              HasSubstr("t.stl:5: 'x' is not a number"));
}

TEST_F(MeshFile, faces_at_nan_infinity_or_overflow_are_dropped_and_the_rest_stays_in_place) {
  const std::string note = "Dropped 1 face with a corner at NaN or infinity.";
  // The bad point comes first: a reader that skips it would shift all others.
  for (const std::string bad : {"nan", "-nan", "inf", "-Infinity", "1e999", "NaN(ind)", "-1.#IND"}) {
    SCOPED_TRACE(bad);
    const std::string point = bad + " 0 0\n";
    const Mesh obj = load("n.obj", "v " + point + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\nf 1 2 3\n");
    EXPECT_EQ(obj.triangles.size(), 1U);
    EXPECT_THAT(obj.notes, Contains(note));
    EXPECT_EQ(obj.positions[0], glm::vec3(0, 0, 0));
    const Mesh off = load("n.off", "OFF\n4 2 0\n" + point + "0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n3 0 1 2\n");
    EXPECT_EQ(off.positions, obj.positions);
    EXPECT_EQ(off.notes, obj.notes);
    const Mesh ply = load("n.ply", replaced(kTetrahedronPly, "0 0 1\n", "0 0 " + bad + "\n"));
    EXPECT_EQ(ply.triangles.size(), 1U);
    EXPECT_THAT(ply.notes, Contains("Dropped 3 faces with a corner at NaN or infinity."));
    const Mesh stl = load("n.stl", replaced(ascii_stl(), "vertex 0 0 1", "vertex 0 0 " + bad));
    EXPECT_EQ(stl.triangles.size(), 3U);
    EXPECT_THAT(stl.notes, Contains(note));
  }
}

TEST_F(MeshFile, binary_nan_is_not_merged_with_other_stl_corners) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::string bytes = binary_stl();
  std::memcpy(bytes.data() + 84 + 12, &nan, 4);
  const Mesh mesh = load("n.stl", bytes);
  EXPECT_EQ(mesh.triangles.size(), 3U);
  EXPECT_THAT(mesh.notes, Contains("Dropped 1 face with a corner at NaN or infinity."));
}

TEST_F(MeshFile, numbers_too_small_for_a_float_are_read_as_zero) {
  expect_tetrahedron(load("s.obj", replaced(kTetrahedronObj, "v 0 0 0", "v 1e-60 -1e-300 +0")));
}

TEST_F(MeshFile, faces_outside_the_vertices_are_dropped_with_an_example) {
  const Mesh obj = load("o.obj", kTetrahedronObj + "f 1 2 99\nf 0 1 2\nf 1 2 99999999999\n");
  expect_tetrahedron(obj);
  EXPECT_THAT(obj.notes, Contains("Dropped 3 faces naming a vertex outside the file's 4 (such as index "
                                  "2,147,483,647, counted from 0)."));
  const Mesh ply =
      load("o.ply", replaced(replaced(kTetrahedronPly, "face 4", "face 6"), "end_header", "end_header") +
                        "3 0 1 4\n3 -1 0 1\n");
  expect_tetrahedron(ply);
  EXPECT_THAT(ply.notes,
              Contains(HasSubstr("Dropped 2 faces naming a vertex outside the file's 4 (such as index ")));
}

TEST_F(MeshFile, faces_without_area_are_dropped_and_counted_in_every_format) {
  const std::string collinear = "v 2 0 0\nf 1 2 5\n";
  const std::string repeated_and_short = "f 1 1 2\nf 2 3\nf 1 2 3\n";
  EXPECT_THAT(load("z.obj", kTetrahedronObj + collinear + repeated_and_short).notes,
              Contains("Dropped 3 faces without area."));
  EXPECT_THAT(
      load("z.off", replaced(replaced(kTetrahedronOff, "4 4 6", "4 5 6"), "3 0 1 3\n", "3 0 1 3\n3 1 1 2\n"))
          .notes,
      Contains("Dropped 1 face without area."));
  const Mesh stl = load("z.stl", replaced(ascii_stl(), "vertex 0 1 0", "vertex 0 0 0"));
  EXPECT_EQ(stl.triangles.size(), 3U);
  EXPECT_THAT(stl.notes, Contains("Dropped 1 face without area."));
}

TEST_F(MeshFile, isolated_vertices_are_removed_and_counted) {
  const Mesh mesh = load(
      "i.obj", "v 9 9 9\nv nan nan nan\n" + replaced(kTetrahedronObj, "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
                                                     "f 3 5 4\nf 3 4 6\nf 3 6 5\nf 4 5 6\n"));
  expect_tetrahedron(mesh);
  EXPECT_THAT(mesh.notes, Contains("Removed 2 isolated vertices that no drawn face uses."));
}

TEST_F(MeshFile, non_manifold_edges_are_kept_and_counted) {
  const Mesh mesh = load("m.obj", kTetrahedronObj + "v 1 1 1\nf 1 2 5\n");
  EXPECT_EQ(mesh.triangles.size(), 5U);
  EXPECT_THAT(mesh.notes, Contains("Kept 1 non-manifold edge, shared by more than two faces."));
}

TEST_F(MeshFile, a_face_that_lies_against_its_neighbours_is_turned_over) {
  const Mesh mesh = load("o.obj", replaced(kTetrahedronObj, "f 1 3 2", "f 1 2 3"));
  EXPECT_THAT(mesh.notes, ::testing::ElementsAre("Turned 1 face over that lay against the neighbours."));
  expect_tetrahedron(mesh);
}

TEST_F(MeshFile, no_face_or_none_left_is_an_error) {
  EXPECT_THAT(failure_of("p.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), HasSubstr("holds 3 points but no faces"));
  EXPECT_THAT(failure_of("p.ply", replaced(replaced(kTetrahedronPly, "face 4", "face 0"), "3 0 2 1", "")),
              HasSubstr("holds 4 points but no faces"));
  EXPECT_THAT(
      failure_of("p.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 3\n"),
      HasSubstr(
          "no face can be drawn: Dropped 1 face with a corner at NaN or infinity. Dropped 1 face without"));
}

TEST_F(MeshFile, malformed_ply_headers_are_refused_quickly) {
  const std::string start = "ply\nformat ascii 1.0\n";
  const std::string points = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string body = "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(load("h.ply", start + points + face + body).triangles.size(), 1U);
  EXPECT_THAT(failure_of("h.ply", start + points + face), HasSubstr("no 'end_header'"));
  EXPECT_THAT(failure_of("h.ply", "ply\nformat text 1.0\n" + points + face + body),
              HasSubstr("unknown PLY format 'text'"));
  EXPECT_THAT(failure_of("h.ply", start + face + body), HasSubstr("announces no vertices"));
  EXPECT_THAT(failure_of("h.ply", start + points + body), HasSubstr("announces no faces"));
  EXPECT_THAT(failure_of("h.ply", start + "property float x\n" + points + face + body),
              HasSubstr("without an element"));
  EXPECT_THAT(failure_of("h.ply", start + replaced(points, "float y", "int x") + face + body),
              HasSubstr("lack one of x, y and z"));
  EXPECT_THAT(failure_of("h.ply", start + points + replaced(face, "int", "float") + body),
              HasSubstr("'vertex_indices' is no list of whole numbers"));
  EXPECT_THAT(failure_of("h.ply", start + points + replaced(face, "vertex_indices", "corners") + body),
              HasSubstr("have no list of vertex indices"));
  EXPECT_THAT(failure_of("h.ply", start + replaced(points, "float y", "quad y") + face + body),
              HasSubstr("unknown PLY type 'quad'"));
  EXPECT_THAT(failure_of("h.ply", start + replaced(points, "3", "-3") + face + body),
              HasSubstr("'-3' is not a number of elements"));
  EXPECT_THAT(failure_of("h.ply", start + points + replaced(face, "1", "99999999999999999") + body),
              HasSubstr("holds 3 and 1"));
}

TEST_F(MeshFile, huge_announced_counts_cost_neither_time_nor_memory) {
  EXPECT_THAT(failure_of("h.off", "OFF\n4000000000 4000000000 0\n0 0 0\n"),
              HasSubstr("but the file holds 1 and 0"));
  EXPECT_THAT(failure_of("h.ply", replaced(kTetrahedronPly, "3 0 2 1", "4000000000 0 2 1")),
              HasSubstr("holds 4 and 0"));
  EXPECT_THAT(failure_of("h.off", replaced(kTetrahedronOff, "3 0 2 1", "4000000000 0 2 1")),
              HasSubstr("of its 4000000000 corners"));
}

TEST_F(MeshFile, unsupported_off_variants_say_so) {
  EXPECT_THAT(failure_of("b.off", "OFF BINARY\n1 1 1\n"), HasSubstr("binary OFF is not supported"));
  EXPECT_THAT(failure_of("4.off", "4OFF\n1 1 1\n"), HasSubstr("homogeneous coordinates"));
  EXPECT_THAT(failure_of("c.off", "OFF\nfour faces\n"), HasSubstr("counts after OFF are missing"));
}

}  // namespace
}  // namespace inkbench
