// SPDX-License-Identifier: MIT
// Camera paths: where the camera is in each frame, worked out by hand, and what a [path] may say.
#include "pipeline/settings/camera_path.h"

#include <glm/geometric.hpp>

#include "tests/unit/support.h"

namespace inkbench {
namespace {

constexpr CameraPath kWhole{.frames = 4, .axis = {0, 1, 0}, .degrees = 360};

void expect_at(const glm::vec3& actual, const glm::vec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-5F) << "component " << i;
}

CameraPath path_of(const std::string& text) {
  return read_path(*parse_toml("[path]\n" + text, "s.toml").find("path"), "s.toml");
}

std::string path_error(const std::string& text) {
  return error_of([&] { path_of(text); });
}

TEST(CameraPath, the_first_frame_is_the_camera_itself) {
  CameraParams camera;
  camera.eye = {0.1F, 0.7F, 3.3F};
  camera.up = {0.3F, 2.0F, 0.1F};  // not of length 1
  EXPECT_EQ(group_text(camera_at(kWhole, camera, 0)), group_text(camera));
}

TEST(CameraPath, turns_about_the_target_counter_clockwise_and_ends_before_the_first_frame) {
  CameraParams camera;
  camera.eye = {1, 2, 8};
  camera.target = {1, 1, 3};
  expect_at(camera_at(kWhole, camera, 1).eye, {6, 2, 3});
  expect_at(camera_at(kWhole, camera, 2).eye, {1, 2, -2});
  expect_at(camera_at(kWhole, camera, 3).eye, {-4, 2, 3});
  EXPECT_DOUBLE_EQ(degrees_at(kWhole, 3), 270);
  expect_at(camera_at(kWhole, camera, 3).target, camera.target);
}

TEST(CameraPath, up_turns_with_the_camera_so_that_it_may_pass_over_the_pole) {
  const CameraPath over{.frames = 4, .axis = {-1, 0, 0}, .degrees = 360};
  const CameraParams camera;  // eye (0, 0, 5), up y
  const CameraParams above = camera_at(over, camera, 1);
  expect_at(above.eye, {0, 5, 0});
  expect_at(above.up, {0, 0, -1});
  EXPECT_NO_THROW(check_camera(above));
}

TEST(CameraPath, a_long_axis_or_up_turns_no_further) {
  CameraParams camera;
  camera.up = {1, 1, 1};
  const CameraPath slanted{.frames = 3, .axis = {1, 1, 1}, .degrees = 360};
  const CameraParams turned = camera_at(slanted, camera, 1);
  expect_at(turned.eye, {5, 0, 0});  // z becomes x
  for (int i = 0; i < 3; ++i) EXPECT_LE(turned.up[i], 1.0F) << "a settings file could not say it";
}

TEST(CameraPath, a_frame_whose_camera_no_file_could_say_is_an_error) {
  Settings settings;
  const auto farthest = static_cast<float>(CameraParams::description().fields.front().limits.high);
  settings.camera.eye = {farthest, 0, farthest};
  const CameraPath eighth{.frames = 8, .axis = {0, 1, 0}, .degrees = 360};
  EXPECT_NO_THROW(settings_at(eighth, settings, 0));
  const std::string error = error_of([&] { settings_at(eighth, settings, 1); });
  EXPECT_EQ(error.rfind("frame 1 of the path: camera.eye", 0), 0U) << error;
}

TEST(CameraPath, a_table_may_leave_everything_out) {
  const CameraPath all = path_of("");
  EXPECT_EQ(all.frames, 180);
  EXPECT_EQ(all.degrees, 360.0F);
  EXPECT_EQ(path_of("frames = 36").degrees, 72.0F) << "2 degrees from frame to frame";
  EXPECT_EQ(path_of("frames = 36\ndegrees = 0").degrees, 0.0F) << "a camera that stands still";
}

TEST(CameraPath, what_is_wrong_is_named_with_its_line) {
  EXPECT_EQ(path_error("frames = 36\ndegres = 72"),
            "s.toml:3: unknown entry 'degres'; did you mean 'degrees'?");
  EXPECT_EQ(path_error("frames = 1"),
            "s.toml:2: path.frames = 1 is out of range; it must be a whole number from 2 to 3600");
  EXPECT_EQ(path_error("axis = [0, 0, 0]"),
            "s.toml:2: path.axis has no length; give a direction, such as [0, 1, 0]");
  EXPECT_EQ(error_of([] { read_path(*parse_toml("path = 3", "s.toml").find("path"), "s.toml"); }),
            "s.toml:1: path is a number; it must be a table: [path]");
}

}  // namespace
}  // namespace inkbench
