// SPDX-License-Identifier: MIT
// Stroke styles as files: bundled ones, one's own, in scenes.
#include "pipeline/settings/style_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/settings/settings_file.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using testing::HasSubstr;

TEST(Styles, every_bundled_one_draws_strokes_and_says_what_it_is_for) {
  const std::vector<std::string> names = style_names();
  EXPECT_EQ(names.size(), 8U);
  for (const std::string& name : names) {
    Settings settings;
    apply_style(settings, name, "", "test");
    EXPECT_NE(settings.ink.from, InkFrom::filter) << name;
    EXPECT_FALSE(style_title(find_style(name, "", "test")).empty()) << name;
  }
}

TEST(Styles, nothing_of_another_style_shows_through) {
  Settings settings, fresh;
  apply_style(settings, "charcoal", "", "test");
  apply_style(settings, "technical", "", "test");
  apply_style(fresh, "technical", "", "test");
  EXPECT_EQ(group_text(settings.stroke), group_text(fresh.stroke));
  for (size_t i = 0; i < kCurveClasses; ++i)
    EXPECT_EQ(group_text(settings.stroke_classes[i]), group_text(fresh.stroke_classes[i]));
}

TEST(Styles, what_is_seen_stays_as_it_is) {
  Settings settings;
  settings.camera.fov = 33.0F;
  settings.judge.crease_angle = 33.0F;
  apply_style(settings, "blueprint", "", "test");
  EXPECT_EQ(settings.camera.fov, 33.0F);
  EXPECT_EQ(settings.judge.crease_angle, 33.0F);
}

TEST(Styles, a_scene_takes_one_and_changes_it) {
  const Settings settings = parse_settings("[stroke]\nwidth = 9.0\n", "test", "");
  const Settings styled = parse_settings("style = \"pencil\"\n[stroke]\nwidth = 9.0\n", "test", "");
  EXPECT_EQ(styled.stroke.brush, Brush::pencil);
  EXPECT_EQ(styled.stroke.width, 9.0F);
  EXPECT_EQ(settings.stroke.brush, Brush::solid);
}

TEST(Styles, ones_own_file_is_found_beside_the_scene_and_its_brush_beside_itself) {
  const TemporaryFolder folder;
  folder.write("styles/mine.toml", "stroke.brush = \"image\"\nstroke.brush_image = \"tip.png\"\n");
  const auto scene = folder.write("scene.toml", "style = \"styles/mine.toml\"\n");
  EXPECT_EQ(std::filesystem::path(load_settings(scene).stroke.brush_image).lexically_normal(),
            (folder.path() / "styles/tip.png").lexically_normal());
}

TEST(Styles, a_misspelt_name_is_an_error_with_the_nearest_one) {
  const std::string error = error_of([] { parse_settings("\nstyle = \"pencill\"\n", "scene.toml", ""); });
  EXPECT_THAT(error, HasSubstr("scene.toml:2"));
  EXPECT_THAT(error, HasSubstr("did you mean 'pencil'"));
}

TEST(Styles, a_camera_is_no_part_of_one) {
  const TemporaryFolder folder;
  const auto file = folder.write("bad.toml", "title = \"bad\"\ncamera.fov = 30\n");
  const std::string error = error_of([&] { read_style(file); });
  EXPECT_THAT(error, HasSubstr("bad.toml:2"));
  EXPECT_THAT(error, HasSubstr("camera.fov is no part of a style"));
}

TEST(Styles, one_does_not_begin_with_another) {
  const TemporaryFolder folder;
  const auto file = folder.write("loop.toml", "style = \"loop.toml\"\n");
  EXPECT_THAT(error_of([&] { read_style(file); }), HasSubstr("loop.toml:1"));
}

TEST(Styles, are_written_as_they_are_read) {
  const TemporaryFolder folder;
  Settings settings, again;
  apply_style(settings, "ink_brush", "", "test");
  settings.stroke_classes[3].width = 0.125F;
  const auto file = folder.write("again.toml", style_text("again", settings));
  apply_style(again, file.string(), "/", "test");
  EXPECT_EQ(settings_text(again), settings_text(settings));
}

}  // namespace
}  // namespace inkbench
