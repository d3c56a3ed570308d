// SPDX-License-Identifier: MIT
// What the readers of OBJ, PLY, OFF and STL take down of a file: points, corners, normals, smoothing groups.
#include "pipeline/mesh/formats/mesh_readers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "pipeline/base/error.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kTrianglePoints = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

PolygonSoup obj(const std::string& text) {
  return read_obj("a.obj", text);
}
PolygonSoup off(const std::string& text) {
  return read_off("a.off", text);
}
PolygonSoup ply(const std::string& text) {
  return read_ply("a.ply", text);
}
PolygonSoup stl(const std::string& text) {
  return read_stl("a.stl", text);
}

template <class Read>
std::string refusal(const Read& read, const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return error.what();
  }
  ADD_FAILURE() << "read: " << text.substr(0, 100);
  return "";
}

std::string with_line_ends(const std::string& text, const std::string& end) {
  std::string result;
  for (const char c : text) result += c == '\n' ? end : std::string(1, c);
  return result;
}

void expect_same(const PolygonSoup& a, const PolygonSoup& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.corner_counts, b.corner_counts);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.corner_normals, b.corner_normals);
  EXPECT_EQ(a.smoothing_groups, b.smoothing_groups);
}

TEST(ObjReader, a_number_is_the_double_nearest_to_its_text) {
  const PolygonSoup soup = obj("v 0.1 500000.123456789 -1e-20\nv +2. .5 1E+300\nv 1e-400 -0 3\nf 1 2 3\n");
  EXPECT_EQ(soup.points[0], glm::dvec3(0.1, 500000.123456789, -1e-20));
  EXPECT_EQ(soup.points[1], glm::dvec3(2.0, 0.5, 1e300));
  EXPECT_EQ(soup.points[2], glm::dvec3(0.0, 0.0, 3.0));
}

TEST(ObjReader, numbers_that_are_not_finite_keep_their_place) {
  const PolygonSoup soup = obj("v nan 1e999 -1.#IND\nv 1 2 3\nv 4 5 6\nf 1 2 3\n");
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(std::isfinite(soup.points[0][i])) << i;
  EXPECT_EQ(soup.points[1], glm::dvec3(1, 2, 3));
}

TEST(ObjReader, each_corner_has_its_own_normal) {
  const PolygonSoup soup =
      obj(kTrianglePoints + "vn 0 0 1\nvn 1 0 0\nvt 0 0\nf 1//1 2/1/2 3//-2\nf 3 2 1//-1\n");
  EXPECT_THAT(soup.normals, ElementsAre(glm::vec3(0, 0, 1), glm::vec3(1, 0, 0)));
  EXPECT_THAT(soup.corner_normals, ElementsAre(0, 1, 0, -1, -1, 1));
}

TEST(ObjReader, a_file_whose_faces_name_no_normal_gives_no_corner_one) {
  EXPECT_THAT(obj(kTrianglePoints + "vn 0 0 1\nf 1 2/1 3/\n").corner_normals, IsEmpty());
}

TEST(ObjReader, a_normal_that_is_not_there_is_none) {
  const PolygonSoup soup = obj(kTrianglePoints + "vn 0 0 1\nf 1//9 2//0 3//-7\n");
  ASSERT_EQ(soup.corner_normals.size(), 3U);
  for (const int32_t normal : soup.corner_normals) EXPECT_TRUE(normal < 0 || normal >= 1) << normal;
}

TEST(ObjReader, smoothing_groups_hold_from_their_line_on) {
  const PolygonSoup soup =
      obj(kTrianglePoints +
          "f 1 2 3\ns 7\nf 1 2 3\nf 2 3 1\ns off\nf 1 2 3\ns 0\nf 1 2 3\ns 4294967295\nf 3 2 1\n");
  EXPECT_THAT(soup.smoothing_groups, ElementsAre(0U, 7U, 7U, 0U, 0U, 4294967295U));
}

TEST(ObjReader, a_file_without_groups_has_none) {
  EXPECT_THAT(obj(kTrianglePoints + "f 1 2 3\n").smoothing_groups, IsEmpty());
}

TEST(ObjReader, a_group_that_is_no_number_is_told) {
  const PolygonSoup soup = obj(kTrianglePoints + "s hull\nf 1 2 3\n");
  EXPECT_THAT(soup.smoothing_groups, ElementsAre(0U));
  EXPECT_THAT(soup.notes, ElementsAre(HasSubstr("1 line 's'")));
}

TEST(ObjReader, a_backslash_joins_lines_wherever_it_stands) {
  const PolygonSoup whole = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\n");
  expect_same(obj("v 0 0 0\nv 1 \\\n0 0\nv 0 1\\\n 0\nv 1 1 0\nf 1 2 4\\\n3\n"), whole);
  expect_same(obj("v 0 0 0\r\nv 1 0 \\ \r\n0\r\nv 0 1 0\r\nv 1 1 0\r\nf 1 2 \\\r\n\\\r\n4 3"), whole);
}

TEST(ObjReader, a_backslash_at_the_end_of_a_comment_or_a_path_joins_nothing) {
  EXPECT_EQ(obj("# C:\\models\\\nv 0 0 0\nmtllib D:\\m\\\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").points.size(), 3U);
}

TEST(Readers, any_line_end_and_a_byte_order_mark_will_do) {
  const std::string text = kTrianglePoints + "s 1\nf 1 2 3\n";
  const std::string off_text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string ply_text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string stl_text =
      "solid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\n"
      "endsolid a b\n";
  for (const std::string end : {"\r\n", "\r"}) {
    for (const std::string mark : {"", "\xEF\xBB\xBF"}) {
      expect_same(obj(mark + with_line_ends(text, end)), obj(text));
      expect_same(off(mark + with_line_ends(off_text, end)), off(off_text));
      expect_same(ply(mark + with_line_ends(ply_text, end)), ply(ply_text));
      expect_same(stl(mark + with_line_ends(stl_text, end)), stl(stl_text));
    }
  }
}

TEST(Readers, an_error_counts_lines_whatever_ends_them) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    EXPECT_THAT(refusal(obj, with_line_ends("v 0 0 0\n\nv 1 x 0\n", end)), HasSubstr("a.obj:3: 'x'"));
  }
}

TEST(ObjReader, free_form_surfaces_alone_are_refused_by_their_name) {
  EXPECT_THAT(refusal(obj, "v 0 0 0\ncstype bezier\nsurf 0 1 0 1 1 2 3\nend\n"), HasSubstr("free-form"));
}

const std::string kCube =
    "-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n"
    "4 0 1 2 3\n4 5 4 7 6\n4 1 5 6 2\n4 4 0 3 7\n4 3 2 6 7\n4 4 5 1 0\n";

TEST(OffReader, every_header_that_means_three_dimensions_is_read) {
  const PolygonSoup cube = off("OFF\n8 6 12\n" + kCube);
  ASSERT_EQ(cube.points.size(), 8U);
  ASSERT_EQ(cube.corner_counts.size(), 6U);
  EXPECT_EQ(cube.points[3], glm::dvec3(-1, 1, 1));
  EXPECT_EQ(cube.corners[4], 5);
  for (const std::string header :
       {"OFF8 6 12\n", "OFF 8 6 12\n", "off\n8 6 12\n", "Off\n8 6 0\n", "8 6 0\n", "OFF\n8 6\n",
        "OFF\n8\n6\n12\n", "nOFF\n3\n8 6 0\n", "nOFF 3\n8 6 0\n", "noff\n3\n8 6 0\n", "noff 3 8 6 0\n",
        "# a comment\n\nOFF # another\n8 6 0 # and one\n"}) {
    SCOPED_TRACE(header);
    expect_same(off(header + kCube), cube);
  }
}

TEST(OffReader, vertices_and_faces_may_share_lines_or_go_on_in_the_next) {
  const PolygonSoup cube = off("OFF\n8 6 12\n" + kCube);
  std::string one_line = "OFF 8 6 12 " + with_line_ends(kCube, " ");
  expect_same(off(one_line), cube);
  std::string word_lines = one_line;
  for (char& c : word_lines) c = c == ' ' ? '\n' : c;
  expect_same(off(word_lines), cube);
  std::string vertices_on_one = with_line_ends(kCube.substr(0, kCube.find("4 0 1")), " ");
  expect_same(off("OFF\n8 6 0\n" + vertices_on_one + "\n" + kCube.substr(kCube.find("4 0 1"))), cube);
}

TEST(OffReader, colours_are_passed_over_wherever_they_stand) {
  const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const PolygonSoup plain = off("OFF\n3 1 0\n" + triangle);
  expect_same(off("COFF\n3 1 0\n0 0 0 9 9 9 9\n1 0 0 9 9 9 9\n0 1 0 9 9 9 9\n3 0 1 2 5 5 5\n"), plain);
  expect_same(off("COFF\n3 1 0\n0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n3 0 1 2 0.5 0.5 0.5 1\n"), plain);
  expect_same(off("COFF 3 1 0 0 0 0 9 9 9 9 1 0 0 9 9 9 9 0 1 0 9 9 9 9 3 0 1 2"), plain);
  expect_same(off("OFF\n3 1 0\n0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1 2\n"), plain);
  expect_same(off("STOFF\n3 1 0\n0 0 0 0.5 0.5\n1 0 0 0.5 0.5\n0 1 0 0.5 0.5\n3 0 1\n2 7\n"), plain);
}

TEST(OffReader, normals_belong_to_their_points) {
  const std::string text = "3 1 0\n0 0 0 0 0 2\n1 0 0 0 1 0\n0 1 0 1 0 0\n3 2 0 1\n";
  for (const std::string keyword : {"NOFF\n", "noff\n"}) {
    const PolygonSoup soup = off(keyword + text);
    EXPECT_THAT(soup.normals, ElementsAre(glm::vec3(0, 0, 2), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0)));
    EXPECT_THAT(soup.corner_normals, ElementsAre(2, 0, 1));
  }
}

TEST(OffReader, points_of_other_dimensions_are_refused_for_that) {
  EXPECT_THAT(refusal(off, "4OFF\n1 0 0\n0 0 0 1\n"), HasSubstr("homogeneous coordinates"));
  EXPECT_THAT(refusal(off, "nOFF\n5\n1 0 0\n0 0 0 1 1\n"), HasSubstr("points of '5' dimensions"));
  EXPECT_THAT(refusal(off, "hello\n"), HasSubstr("not an OFF file"));
}

TEST(OffReader, what_follows_the_announced_faces_is_told) {
  EXPECT_THAT(off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n").notes,
              ElementsAre(HasSubstr("Left out what follows the 1 face that")));
}

std::string ply_of(const std::string& vertex_type, const std::string& element, const std::string& body) {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty " + vertex_type + " x\nproperty " + vertex_type +
         " y\nproperty " + vertex_type + " z\nelement " + element + "\nend_header\n" + body;
}

const std::string kSquare = "-1 -1 0\n1 -1 0\n-1 1 0\n1 1 0\n";

TEST(PlyReader, coordinates_of_any_type_are_numbers) {
  for (const std::string type : {"int", "short", "char", "float", "double"}) {
    const PolygonSoup soup =
        ply(ply_of(type, "face 1\nproperty list uchar int vertex_indices", kSquare + "4 0 1 3 2\n"));
    EXPECT_EQ(soup.points[0], glm::dvec3(-1, -1, 0)) << type;
  }
}

TEST(PlyReader, strips_turn_every_second_triangle_and_begin_again_after_minus_one) {
  const PolygonSoup soup = ply(ply_of("float", "tristrips 2\nproperty list int int vertex_indices",
                                      kSquare + "8 0 1 2 3 -1 3 2 1\n4 0 1 1 2\n"));
  EXPECT_THAT(soup.corner_counts, ElementsAre(3U, 3U, 3U));
  EXPECT_THAT(soup.corners, ElementsAre(0, 1, 2, 2, 1, 3, 3, 2, 1));
}

TEST(PlyReader, a_header_line_of_any_words_may_stand_before_the_elements_alone) {
  const std::string text =
      ply_of("float", "face 1\nproperty list uchar int vertex_indices", kSquare + "4 0 1 3 2\n");
  std::string early = text, late = text;
  early.insert(early.find("element vertex"), "Created by Blender3D\n");
  late.insert(late.find("element face"), "Created by Blender3D\n");
  expect_same(ply(early), ply(text));
  EXPECT_THAT(refusal(ply, late), HasSubstr("'Created' has no place in a PLY header"));
}

TEST(PlyReader, faces_may_stand_before_vertices) {
  const PolygonSoup soup =
      ply("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_index\nelement vertex 3\n"
          "property float x\nproperty float y\nproperty float z\nend_header\n3 2 1 0\n0 0 0\n1 0 0\n0 1 0\n");
  EXPECT_THAT(soup.corners, ElementsAre(2, 1, 0));
  EXPECT_EQ(soup.points.size(), 3U);
}

TEST(PlyReader, binary_data_after_a_header_of_lone_returns_keeps_its_first_byte) {
  std::string text = with_line_ends(
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\nproperty "
      "char z\n"
      "element face 1\nproperty list uchar uchar vertex_index\nend_header\n",
      "\r");
  const PolygonSoup soup = ply(text + std::string("\n\0\0\1\0\0\0\1\0\3\0\1\2", 13));
  EXPECT_EQ(soup.points[0], glm::dvec3(10, 0, 0));
  EXPECT_THAT(soup.corners, ElementsAre(0, 1, 2));
}

TEST(PlyReader, what_is_no_mesh_is_named) {
  EXPECT_THAT(refusal(ply, "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n"),
              HasSubstr("point cloud"));
  EXPECT_THAT(refusal(ply,
                      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nelement range_grid 1\n"
                      "property list uchar int vertex_indices\nend_header\n"),
              HasSubstr("range scan"));
}

std::string binary_stl_of(uint32_t announced, int facets, const std::string& header = "") {
  std::string bytes = header;
  bytes.resize(80);
  bytes.append(reinterpret_cast<const char*>(&announced), 4);
  const float corners[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  for (int i = 0; i < facets; ++i) {
    bytes.append(reinterpret_cast<const char*>(corners), sizeof corners);
    bytes.append(2, '\0');
  }
  return bytes;
}

TEST(StlReader, corners_are_points_of_their_own_that_rounding_may_part) {
  const PolygonSoup soup = stl(binary_stl_of(2, 2));
  EXPECT_TRUE(soup.corners_are_rounded);
  EXPECT_EQ(soup.points.size(), 6U);
  EXPECT_THAT(soup.corners, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(StlReader, bytes_after_the_facets_are_left_out_and_told) {
  const PolygonSoup soup = stl(binary_stl_of(2, 2, "solid but binary") + "made by X");
  EXPECT_EQ(soup.corner_counts.size(), 2U);
  EXPECT_THAT(soup.notes, ElementsAre(HasSubstr("Left out 9 bytes after the 2 facets")));
}

TEST(StlReader, a_count_that_was_never_written_is_taken_from_the_size) {
  for (const uint32_t announced : {0U, 0xFFFFFFFFU}) {
    const PolygonSoup soup = stl(binary_stl_of(announced, 3));
    EXPECT_EQ(soup.corner_counts.size(), 3U);
    EXPECT_THAT(soup.notes, ElementsAre(HasSubstr("the file's size says 3")));
  }
  EXPECT_THAT(refusal(stl, binary_stl_of(0, 0)), HasSubstr("holds no facets"));
}

const std::string kLoop = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

TEST(StlReader, keywords_may_share_lines_in_any_case) {
  const PolygonSoup soup = stl("solid\nfacet normal 0 0 1 outer loop\n" + kLoop + "endsolid\n");
  expect_same(stl("SOLID\nFACET NORMAL 0 0 1\nOUTER LOOP\n" + kLoop + "ENDSOLID\n"), soup);
  expect_same(
      stl("solid facet\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0\nvertex 0\n1 0 endloop "
          "endfacet endsolid facet\n"),
      soup);
  expect_same(stl("solid a facet normal 0 0 1 outer loop " + with_line_ends(kLoop, " ") + " endsolid a"),
              soup);
}

TEST(StlReader, several_solids_are_one_soup) {
  const std::string one = "solid a\nfacet normal 0 0 1\nouter loop\n" + kLoop + "endsolid a\n";
  EXPECT_EQ(stl(one + one).corner_counts.size(), 2U);
  EXPECT_THAT(refusal(stl, one + one.substr(0, one.find("endsolid"))), HasSubstr("no 'endsolid' after 2"));
}

}  // namespace
}  // namespace inkbench
