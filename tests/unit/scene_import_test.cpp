// SPDX-License-Identifier: MIT
// Other programs' files: parts in their places, colours, cameras and lights, and what is wrong with a file.
#include "pipeline/mesh/formats/scene_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <glm/geometric.hpp>

#include "pipeline/base/error.h"
#include "pipeline/base/scratch_folder.h"
#include "pipeline/mesh/formats/scene_box.h"
#include "pipeline/mesh/formats/scene_transfer.h"
#include "tests/written_gltf.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SceneImport : public ::testing::Test {
 protected:
  std::shared_ptr<const ImportedScene> import(const GltfText& text) {
    return import_scene(write_gltf(folder_.path(), text));
  }
  fs::path write(const std::string& name, const std::string& content) {
    std::ofstream(folder_.path() / name, std::ios::binary) << content;
    return folder_.path() / name;
  }
  static std::string failure(const fs::path& path) {
    try {
      import_scene(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
      return error.what();
    }
    ADD_FAILURE() << path << " was read";
    return "";
  }

  ScratchFolder folder_;
};

/// Of the first face, by its corners' order.
glm::dvec3 face_normal(const PolygonSoup& soup) {
  const auto point = [&](size_t corner) { return soup.points[static_cast<size_t>(soup.corners[corner])]; };
  return glm::normalize(glm::cross(point(1) - point(0), point(2) - point(0)));
}

std::vector<std::string> part_names(const ImportedScene& scene) {
  std::vector<std::string> names;
  for (const ImportedPart& part : scene.parts) names.push_back(part.name);
  return names;
}

TEST_F(SceneImport, each_part_stands_where_its_nodes_put_it) {
  const auto scene = import({.nodes = R"({"name": "arm", "translation": [10, 0, 0], "children": [1, 2]},
                                         {"name": "hand", "mesh": 0, "scale": [2, 3, 1]},
                                         {"name": "hand", "mesh": 0, "translation": [0, 5, 0]})"});
  EXPECT_THAT(part_names(*scene), ElementsAre("hand", "hand 2"));
  EXPECT_EQ(scene->parts[0].soup.points[2], glm::dvec3(12, 3, 0));
  EXPECT_EQ(scene->parts[1].soup.points[2], glm::dvec3(11, 6, 0));
}

TEST_F(SceneImport, a_mirrored_part_keeps_its_outside) {
  const auto scene =
      import({.nodes = R"({"mesh": 0, "scale": [-1, 1, 1]}, {"mesh": 0, "scale": [-1, -1, 1]})",
              .scene_nodes = "0, 1"});
  for (const ImportedPart& part : scene->parts) EXPECT_EQ(face_normal(part.soup), glm::dvec3(0, 0, 1));
}

TEST_F(SceneImport, normals_turn_with_their_part_also_where_it_is_stretched_and_mirrored) {
  const auto scene =
      import({.nodes = R"({"mesh": 0, "scale": [-2, 1, 1]})", .attributes = R"(, "NORMAL": 0)"});
  const PolygonSoup& soup = scene->parts[0].soup;
  const auto corner =
      static_cast<size_t>(std::ranges::find(soup.points, glm::dvec3(-2, 1, 0)) - soup.points.begin());
  ASSERT_LT(corner, soup.points.size());
  EXPECT_EQ(soup.corner_normals, soup.corners);
  EXPECT_NEAR(glm::length(soup.normals[corner] - glm::normalize(glm::vec3(-0.5F, 1.0F, 0.0F))), 0.0, 1e-6);
}

TEST_F(SceneImport, joined_parts_keep_their_own_corners) {
  const auto scene =
      import({.nodes = R"({"mesh": 0}, {"mesh": 0, "translation": [0, 0, 4]})", .scene_nodes = "0, 1"});
  const PolygonSoup all = joined_soup(*scene);
  EXPECT_EQ(all.points.size(), scene->parts[0].soup.points.size() * 2);
  EXPECT_EQ(all.corner_counts.size(), 4U);
  EXPECT_EQ(all.points[static_cast<size_t>(all.corners[0])].z, 0.0);
  EXPECT_EQ(all.points[static_cast<size_t>(all.corners[6])].z, 4.0);
}

TEST(JoinedSoup, a_corner_that_names_nothing_in_its_part_names_nothing_in_another) {
  ImportedScene scene;
  PolygonSoup part;
  part.points.resize(3);
  part.normals = {{0, 0, 1}};
  part.corner_counts = {3};
  part.corners = {0, 1, 3};
  part.corner_normals = {0, 1, -5};
  scene.parts = {{"a", part}, {"b", part}};
  const PolygonSoup all = joined_soup(scene);
  EXPECT_THAT(all.corners, ElementsAre(0, 1, -1, 3, 4, -1));
  EXPECT_THAT(all.corner_normals, ElementsAre(0, -1, -1, 1, -1, -1));
}

TEST_F(SceneImport, a_gltf_without_normals_is_flat) {
  const auto scene = import({});
  EXPECT_THAT(scene->parts[0].soup.corner_normals, IsEmpty());
  EXPECT_TRUE(scene->parts[0].soup.is_flat);
  EXPECT_TRUE(joined_soup(*scene).is_flat);
}

TEST_F(SceneImport, a_material_colours_its_part_as_it_is_displayed) {
  const auto scene =
      import({.primitive = R"(, "material": 0)",
              .more = R"(, "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1]}}])"});
  const glm::vec3 colour = scene->parts[0].colour;
  EXPECT_NEAR(colour.x, 1.0, 1e-6);
  EXPECT_NEAR(colour.y, 0.7353570, 1e-5);
  EXPECT_NEAR(colour.z, 0.0, 1e-6);
}

/// A triangle, and what else the file's library and scene hold.
std::string collada(const std::string& library, const std::string& nodes) {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
      <asset><up_axis>Y_UP</up_axis></asset>)" +
         library + R"(<library_geometries><geometry id="g"><mesh><source id="p">
      <float_array id="pa" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>
      <accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
      <param name="Z" type="float"/></accessor></technique_common></source><vertices id="v">
      <input semantic="POSITION" source="#p"/></vertices><triangles count="1">
      <input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
      </library_geometries><library_visual_scenes><visual_scene id="s">
      <node id="n"><instance_geometry url="#g"/></node>)" +
         nodes +
         R"(</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

TEST_F(SceneImport, cameras_look_from_their_nodes) {
  const auto scene = import(
      {.nodes =
           R"({"mesh": 0}, {"name": "eye", "camera": 0, "translation": [1, 2, 3], "rotation": [0, 1, 0, 0]})",
       .scene_nodes = "0, 1",
       .more =
           R"(, "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7853981634, "znear": 0.1}}])"});
  ASSERT_EQ(scene->cameras.size(), 1U);
  const ImportedCamera& camera = scene->cameras[0];
  EXPECT_NEAR(glm::length(camera.eye - glm::dvec3(1, 2, 3)), 0.0, 1e-6);
  EXPECT_NEAR(glm::length(glm::normalize(camera.direction) - glm::dvec3(0, 0, 1)), 0.0, 1e-6);
  EXPECT_NEAR(camera.horizontal_fov_deg, 45.0, 1e-4);
  EXPECT_EQ(camera.aspect, 1.0);
}

TEST_F(SceneImport, an_orthographic_camera_shows_what_it_did) {
  // ymag is half of the height; a node's scale is none of the camera's.
  const auto scene = import(
      {.nodes = R"({"mesh": 0}, {"name": "eye", "camera": 0, "translation": [1, 2, 3], "scale": [5, 5, 5]})",
       .scene_nodes = "0, 1",
       .more = R"(, "cameras": [{"type": "orthographic",
                  "orthographic": {"xmag": 3, "ymag": 2, "zfar": 100, "znear": 0.1}}])"});
  ASSERT_EQ(scene->cameras.size(), 1U);
  const ImportedCamera& camera = scene->cameras[0];
  EXPECT_NEAR(glm::length(camera.eye - glm::dvec3(1, 2, 3)), 0.0, 1e-6);
  EXPECT_NEAR(glm::length(glm::normalize(camera.direction) - glm::dvec3(0, 0, -1)), 0.0, 1e-6);
  EXPECT_NEAR(camera.view_height, 4.0, 1e-6);
  EXPECT_THAT(scene->view_notes, IsEmpty());
}

TEST_F(SceneImport, a_collada_files_orthographic_camera_is_left_out_and_told) {
  // Assimp takes its size for an angle.
  const std::string camera =
      R"(<library_cameras><camera id="cam" name="cam"><optics><technique_common><orthographic>
      <xmag>1.5</xmag><aspect_ratio>1</aspect_ratio><znear>1</znear><zfar>9</zfar></orthographic>
      </technique_common></optics></camera></library_cameras>)";
  const auto scene =
      import_scene(write("c.dae", collada(camera, R"(<node><instance_camera url="#cam"/></node>)")));
  EXPECT_THAT(scene->cameras, IsEmpty());
  EXPECT_THAT(scene->view_notes, ElementsAre(HasSubstr("Left out the cameras")));
  EXPECT_EQ(scene->parts.size(), 1U);
  // And nothing is known of one without a name.
  std::string nameless = camera;
  nameless.erase(nameless.find(" name="), std::string(" name=\"cam\"").size());
  const auto other =
      import_scene(write("d.dae", collada(nameless, R"(<node id="c"><instance_camera url="#cam"/></node>)")));
  EXPECT_THAT(other->cameras, IsEmpty());
  EXPECT_THAT(other->view_notes, ElementsAre(HasSubstr("Left out the camera 'c'")));
}

TEST_F(SceneImport, lights_have_place_or_direction) {
  const auto scene = import(
      {.nodes = R"({"mesh": 0}, {"name": "sun", "extensions": {"KHR_lights_punctual": {"light": 0}}},
                   {"name": "lamp", "translation": [0, 4, 0], "extensions": {"KHR_lights_punctual": {"light": 1}}})",
       .scene_nodes = "0, 1, 2",
       .more =
           R"(, "extensionsUsed": ["KHR_lights_punctual"], "extensions": {"KHR_lights_punctual": {"lights": [
                  {"type": "directional", "color": [1, 1, 0.5], "intensity": 2}, {"type": "point"}]}})"});
  ASSERT_EQ(scene->lights.size(), 2U);
  EXPECT_EQ(scene->lights[0].type, ImportedLightType::directional);
  EXPECT_NEAR(glm::length(glm::normalize(scene->lights[0].direction) - glm::dvec3(0, 0, 1)), 0.0, 1e-6);
  EXPECT_NEAR(scene->lights[0].intensity.z / scene->lights[0].intensity.x, 0.5, 1e-6);
  EXPECT_EQ(scene->lights[1].type, ImportedLightType::point);
  EXPECT_NEAR(glm::length(scene->lights[1].position - glm::dvec3(0, 4, 0)), 0.0, 1e-6);
}

TEST_F(SceneImport, parts_are_found_by_name_and_by_number) {
  const auto scene =
      import({.nodes = R"({"name": "wheel", "mesh": 0}, {"name": "1", "mesh": 0})", .scene_nodes = "0, 1"});
  EXPECT_EQ(find_part(*scene, "wheel", "f").name, "wheel");
  EXPECT_EQ(find_part(*scene, "2", "f").name, "1");
  EXPECT_EQ(find_part(*scene, "1", "f").name, "1");
  try {
    find_part(*scene, "whel", "f.gltf");
    ADD_FAILURE() << "found";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("f.gltf: has no part 'whel' among its 2; did you mean 'wheel'?"));
  }
}

TEST_F(SceneImport, a_scene_far_away_or_very_large_or_small_comes_into_reach) {
  for (const std::string node :
       {R"({"mesh": 0, "translation": [500000, 0, 0]})", R"({"mesh": 0, "scale": [1e6, 1e6, 1e6]})",
        R"({"mesh": 0, "scale": [1e-6, 1e-6, 1e-6]})"}) {
    SCOPED_TRACE(node);
    const auto scene = import({.nodes = node});
    const SceneBox box = box_of(*scene);
    EXPECT_LT(glm::length(box.middle()), 100.0);
    EXPECT_GT(box.radius(), 0.4);
    EXPECT_LT(box.radius(), 6.0);
    EXPECT_EQ(scene->notes.size(), 1U);
    fs::remove(folder_.path() / "square.gltf");
  }
}

TEST_F(SceneImport, a_scene_that_places_in_settings_hold_stays_as_large_as_it_is) {
  const auto scene = import({.nodes = R"({"mesh": 0, "scale": [1e5, 1e5, 1e5]})"});
  EXPECT_NEAR(box_of(*scene).high.x, 1e5, 1.0);
  EXPECT_THAT(scene->notes, IsEmpty());
  fs::remove(folder_.path() / "square.gltf");
  const auto far =
      import({.nodes = R"({"mesh": 0, "translation": [900000, 0, 0], "scale": [1e5, 1e5, 1e5]})"});
  EXPECT_LT(glm::length(box_of(*far).middle()), 1.0);
  EXPECT_EQ(far->notes.size(), 1U);
}

TEST_F(SceneImport, a_file_is_read_again_when_it_or_its_buffer_changes) {
  const fs::path path = write_gltf(folder_.path());
  const auto first = import_scene(path);
  EXPECT_EQ(import_scene(path), first);
  fs::last_write_time(folder_.path() / "square.bin",
                      fs::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_NE(import_scene(path), first);
}

TEST_F(SceneImport, the_buffers_of_a_gltf_are_files_that_it_is_read_with) {
  const fs::path path = write_gltf(folder_.path(), {}, "my model", "my buffer.bin", "my%20buffer.bin");
  EXPECT_THAT(files_read_with(path), ElementsAre(path, folder_.path() / "my buffer.bin"));
  EXPECT_NO_THROW(import_scene(path));
  EXPECT_THAT(files_read_with(folder_.path() / "a.obj"), ElementsAre(folder_.path() / "a.obj"));
}

TEST_F(SceneImport, a_missing_buffer_is_named) {
  const fs::path path = write_gltf(folder_.path());
  fs::remove(folder_.path() / "square.bin");
  EXPECT_THAT(failure(path), HasSubstr("its buffer is missing: " + (folder_.path() / "square.bin").string()));
}

TEST_F(SceneImport, damaged_empty_and_missing_files_are_refused) {
  EXPECT_THAT(failure(write("bad.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"scenes\": 3}")),
              HasSubstr("bad.gltf: cannot be read: "));
  EXPECT_THAT(failure(write("noise.fbx", "noise")), HasSubstr("noise.fbx: cannot be read: "));
  EXPECT_THAT(failure(write("empty.glb", "")), HasSubstr("is empty"));
  EXPECT_THAT(failure(folder_.path() / "none.dae"), HasSubstr("no such file"));
  EXPECT_THAT(failure(write_gltf(folder_.path(), {.nodes = R"({"name": "nothing"})"})),
              HasSubstr("holds no faces"));
}

/// Objects 1 (geometry) and 2 (model) of a file whose up is z and whose unit is 2.54 cm.
const std::string kInchesFbx = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
	FBXHeaderVersion: 1003
	FBXVersion: 7400
}
GlobalSettings:  {
	Version: 1000
	Properties70:  {
		P: "UpAxis", "int", "Integer", "",2
		P: "UpAxisSign", "int", "Integer", "",1
		P: "FrontAxis", "int", "Integer", "",1
		P: "FrontAxisSign", "int", "Integer", "",-1
		P: "CoordAxis", "int", "Integer", "",0
		P: "CoordAxisSign", "int", "Integer", "",1
		P: "UnitScaleFactor", "double", "Number", "",2.54
	}
}
Objects:  {
	Geometry: 1, "Geometry::tall", "Mesh" {
		Vertices: *9 {
			a: 0,0,0,100,0,0,0,0,300
		}
		PolygonVertexIndex: *3 {
			a: 0,1,-3
		}
		GeometryVersion: 124
	}
	Model: 2, "Model::tall", "Mesh" {
		Version: 232
	}
}
Connections:  {
	C: "OO",1,2
	C: "OO",2,0
}
)";

TEST_F(SceneImport, fbx_comes_in_metres_with_y_up) {
  const auto scene = import_scene(write("inches.fbx", kInchesFbx));
  const SceneBox box = box_of(*scene);
  EXPECT_NEAR(box.high.x, 2.54, 1e-6);
  EXPECT_NEAR(box.high.y, 7.62, 1e-6);
  EXPECT_NEAR(glm::length(face_normal(scene->parts[0].soup) - glm::dvec3(0, 0, 1)), 0.0, 1e-6);
}

TEST(SceneTransfer, what_is_sent_arrives) {
  ImportedScene scene;
  PolygonSoup soup;
  soup.points = {{1, 2, 3}, {4, 5, 6}};
  soup.corner_counts = {3};
  soup.corners = {0, 1, 7};
  soup.normals = {{0, 1, 0}};
  soup.corner_normals = {0, -1, 0};
  soup.smoothing_groups = {4};
  soup.is_flat = true;
  soup.empty_polygons = 5;
  soup.notes = {"note"};
  scene.parts = {{"part", soup, {0.1F, 0.2F, 0.3F}}};
  scene.cameras = {{"camera", {1, 2, 3}, {0, 1, 0}, {1, 0, 0}, 30.0, 1.5, 7.0}};
  scene.lights = {{"light", ImportedLightType::point, {7, 8, 9}, {0, 0, 1}, {3, 2, 1}}};
  scene.notes = {"moved"};
  scene.view_notes = {"left out"};
  std::vector<uint8_t> bytes;
  const ByteSink sink = [&](std::span<const uint8_t> data) {
    bytes.insert(bytes.end(), data.begin(), data.end());
  };
  send_scene(scene, sink);
  const ImportedScene back = receive_scene(bytes);
  ASSERT_EQ(back.parts.size(), 1U);
  EXPECT_EQ(back.parts[0].name, "part");
  EXPECT_EQ(back.parts[0].colour, scene.parts[0].colour);
  EXPECT_EQ(back.parts[0].soup.points, soup.points);
  EXPECT_EQ(back.parts[0].soup.corners, soup.corners);
  EXPECT_EQ(back.parts[0].soup.corner_normals, soup.corner_normals);
  EXPECT_EQ(back.parts[0].soup.smoothing_groups, soup.smoothing_groups);
  EXPECT_TRUE(back.parts[0].soup.is_flat);
  EXPECT_EQ(back.parts[0].soup.empty_polygons, 5U);
  EXPECT_EQ(back.parts[0].soup.notes, soup.notes);
  EXPECT_EQ(back.cameras[0].horizontal_fov_deg, 30.0);
  EXPECT_EQ(back.cameras[0].view_height, 7.0);
  EXPECT_EQ(back.lights[0].type, ImportedLightType::point);
  EXPECT_EQ(back.lights[0].intensity, glm::dvec3(3, 2, 1));
  EXPECT_EQ(back.view_notes, scene.view_notes);
  for (size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(receive_scene(std::span(bytes).first(length)), Error) << length;
  bytes.push_back(0);
  EXPECT_THROW(receive_scene(bytes), Error) << "longer";
}

TEST(SceneTransfer, soups_that_contradict_themselves_are_refused) {
  ImportedScene scene;
  scene.parts.resize(1);
  scene.parts[0].soup.corner_counts = {3};
  scene.parts[0].soup.corners = {0, 1};
  std::vector<uint8_t> bytes;
  const ByteSink sink = [&](std::span<const uint8_t> data) {
    bytes.insert(bytes.end(), data.begin(), data.end());
  };
  send_scene(scene, sink);
  EXPECT_THROW(receive_scene(bytes), Error);
}

}  // namespace
}  // namespace inkbench
