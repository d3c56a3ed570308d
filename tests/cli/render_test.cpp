// SPDX-License-Identifier: MIT
// `inkbench render`: the files it writes and that their pixels are what the settings say.
#include <algorithm>
#include <cmath>

#include "pipeline/buffers.h"
#include "pipeline/image/image_file.h"
#include "pipeline/settings/settings_file.h"
#include "tests/cli/cli_test.h"

namespace inkbench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Render : public CliTest {
 protected:
  Render() { write("scene.toml", small_scene()); }

  /// Renders the small scene with more arguments into a folder of the test.
  CommandResult render(const std::string& out, std::vector<std::string> arguments = {}) const {
    arguments.insert(arguments.begin(), {"render", "--scene", "scene.toml", "--out", out});
    return inkbench(arguments);
  }

  Picture picture(const std::string& name) const { return read_picture(file(name), 3); }

  /// The final picture with those settings.
  Picture final_with(const std::vector<std::string>& assignments) const {
    std::vector<std::string> arguments;
    for (const std::string& assignment : assignments) {
      arguments.emplace_back("--set");
      arguments.push_back(assignment);
    }
    EXPECT_TRUE(succeeds(render("with", arguments)));
    return picture("with/final.png");
  }
};

struct Centre {
  double x = 0, y = 0;
};

/// The middle of the pixels whose object id is `id`, in pixels from the upper left corner.
Centre centre_of_object(const Image& object_id, float id) {
  Centre sum;
  int count = 0;
  for (int y = 0; y < object_id.height_px; ++y) {
    for (int x = 0; x < object_id.width_px; ++x) {
      if (object_id.at(x, y) != id) continue;
      sum.x += x;
      sum.y += y;
      ++count;
    }
  }
  EXPECT_GT(count, 0) << "object " << id << " is not in the picture";
  return {sum.x / count, sum.y / count};
}

TEST_F(Render, without_buffers_writes_final_alone) {
  const CommandResult result = render("new/folders/out");
  ASSERT_TRUE(succeeds(result));
  EXPECT_EQ(result.out, "new/folders/out/final.png\n");
  EXPECT_EQ(folder_content(file("new")).size(), 1U);
  EXPECT_EQ(picture("new/folders/out/final.png").width_px, 64);
  EXPECT_EQ(picture("new/folders/out/final.png").height_px, 48);
}

TEST_F(Render, all_buffers_have_the_size_and_channels_they_promise) {
  ASSERT_TRUE(succeeds(render("png", {"--buffers", "all"})));
  ASSERT_TRUE(succeeds(render("exr", {"--buffers", "all", "--format", "exr"})));
  EXPECT_EQ(folder_content(file("png")).size(), all_buffers().size());
  EXPECT_EQ(folder_content(file("exr")).size(), all_buffers().size());
  for (const BufferName which : all_buffers()) {
    const std::string_view name = name_of(which);
    const Image png = read_image(file("png/" + std::string(name) + ".png"));
    const Image exr = read_image(file("exr/" + std::string(name) + ".exr"));
    const bool is_colour =
        name == "normal" || name == "shaded" || name == "final" || name == "blinn_phong" || name == "albedo";
    EXPECT_EQ(png.channels, 3) << name;
    const bool is_pair = name == "motion" || name == "pair_angles" || name == "pair_gaps";
    const bool is_over_white = name == "curves" || name == "strokes";
    EXPECT_EQ(exr.channels, is_colour ? 3 : is_over_white ? 4 : is_pair ? 2 : 1) << name;
    for (const Image& image : {png, exr}) {
      EXPECT_EQ(image.width_px, 64) << name;
      EXPECT_EQ(image.height_px, 48) << name;
    }
  }
}

TEST_F(Render, named_buffers_are_written_in_that_order) {
  const CommandResult result = render("out", {"--buffers", "depth,normal"});
  ASSERT_TRUE(succeeds(result));
  EXPECT_EQ(result.out, "out/depth.png\nout/normal.png\n");
}

TEST_F(Render, unknown_buffer_suggests_the_nearest) {
  EXPECT_TRUE(
      is_input_error(render("out", {"--buffers", "dept"}), {"--buffers", "dept", "did you mean 'depth'?"}));
  EXPECT_FALSE(fs::exists(file("out")));
}

TEST_F(Render, picture_is_the_raw_value_times_the_gain) {
  const std::vector<std::string> set{"--set", "display.depth_gain=1.5", "--buffers", "all"};
  ASSERT_TRUE(succeeds(render("png", set)));
  std::vector<std::string> raw = set;
  raw.insert(raw.end(), {"--format", "exr"});
  ASSERT_TRUE(succeeds(render("exr", raw)));
  const std::map<std::string, float> gains{{"depth", 1.5F},
                                           {"depth_edges", 128.0F},
                                           {"normal_edges", 16.0F},
                                           {"edge_strength", 0.5F},
                                           {"pair_angles", DisplayParams{}.pair_angles_gain}};
  for (const BufferName which : all_buffers()) {
    const std::string_view buffer = name_of(which);
    if (buffer == "object_id" || buffer == "reference" || buffer == "motion" || buffer == "material_id" ||
        buffer == "edge_class")
      continue;  // colours of their own
    const std::string name(buffer);
    const Picture png = picture("png/" + name + ".png");
    const Image exr = read_image(file("exr/" + name + ".exr"));
    const float gain = gains.contains(name) ? gains.at(name) : 1.0F;
    for (size_t i = 0; i < png.samples.size(); ++i) {
      const float value = exr.samples[exr.channels < 3 ? i / 3 : i / 3 * exr.channels + i % 3];
      const float expected = std::round(std::clamp(value * gain, 0.0F, 1.0F) * 255.0F);
      ASSERT_NEAR(png.samples[i], expected, 1.0F) << name << " sample " << i;
    }
  }
}

TEST_F(Render, reference_lines_are_coloured_where_the_raw_values_name_a_class) {
  ASSERT_TRUE(succeeds(render("out", {"--buffers", "reference"})));
  ASSERT_TRUE(succeeds(render("out", {"--buffers", "reference", "--format", "exr"})));
  ASSERT_TRUE(succeeds(render("out", {"--buffers", "reference", "--format", "svg"})));
  const Image classes = read_image(file("out/reference.exr"));
  const Picture colours = picture("out/reference.png");
  size_t lines = 0;
  for (size_t i = 0; i < classes.samples.size(); ++i) {
    const bool white = colours.samples[3 * i] == 255 && colours.samples[3 * i + 1] == 255 &&
                       colours.samples[3 * i + 2] == 255;
    ASSERT_EQ(white, classes.samples[i] == 0.0F) << i;
    lines += white ? 0 : 1;
  }
  EXPECT_GT(lines, 50U);
  const std::string svg = content_of(file("out/reference.svg"));
  EXPECT_NE(svg.find("<g id=\"silhouette\""), std::string::npos);
  EXPECT_NE(svg.find("<path"), std::string::npos);
  EXPECT_TRUE(
      is_input_error(render("out", {"--buffers", "final", "--format", "svg"}), {"final", "reference"}));
}

TEST_F(Render, object_ids_count_the_scenes_models_and_show_as_distinct_colours) {
  ASSERT_TRUE(succeeds(render("out", {"--buffers", "object_id"})));
  ASSERT_TRUE(succeeds(render("out", {"--buffers", "object_id", "--format", "exr"})));
  const Image ids = read_image(file("out/object_id.exr"));
  const Picture colours = picture("out/object_id.png");
  std::map<float, std::array<uint8_t, 3>> colour_of;
  for (size_t i = 0; i < ids.samples.size(); ++i) {
    const std::array<uint8_t, 3> colour{colours.samples[3 * i], colours.samples[3 * i + 1],
                                        colours.samples[3 * i + 2]};
    ASSERT_EQ(colour_of.try_emplace(ids.samples[i], colour).first->second, colour) << i;
  }
  std::set<std::array<uint8_t, 3>> distinct;
  std::vector<float> seen;
  for (const auto& [id, colour] : colour_of) {
    seen.push_back(id);
    distinct.insert(colour);
  }
  EXPECT_THAT(seen, ElementsAre(0.0F, 1.0F, 2.0F, 3.0F));
  EXPECT_EQ(distinct.size(), 4U);
}

TEST_F(Render, row_0_is_the_top_in_both_formats) {
  ASSERT_TRUE(succeeds(render("out", {"--buffers", "object_id,normal", "--format", "exr"})));
  ASSERT_TRUE(succeeds(render("out", {"--buffers", "normal"})));
  const Image ids = read_image(file("out/object_id.exr"));
  const Centre box = centre_of_object(ids, 1);
  const Centre ball = centre_of_object(ids, 2);
  EXPECT_LT(box.x, 28);
  EXPECT_GT(box.y, 26) << "the box is low";
  EXPECT_GT(ball.x, 36);
  EXPECT_LT(ball.y, 20) << "the ball is high";
  const Image exr = read_image(file("out/normal.exr"));
  const Picture png = picture("out/normal.png");
  for (size_t i = 0; i < png.samples.size(); ++i)
    ASSERT_NEAR(png.samples[i], exr.samples[i] * 255.0F, 1.0F) << i;
}

TEST_F(Render, odd_sizes_are_drawn_whole) {
  for (const std::string size : {"317x203", "1x1", "1x37"}) {
    for (const std::string format : {"png", "exr"}) {
      ASSERT_TRUE(succeeds(render(size, {"--size", size, "--buffers", "all", "--format", format}))) << size;
      const Image image = read_image(file(size + "/final." + format));
      EXPECT_EQ(std::to_string(image.width_px) + "x" + std::to_string(image.height_px), size);
    }
  }
}

TEST_F(Render, set_overrides_size_wherever_it_stands) {
  ASSERT_TRUE(succeeds(render("a", {"--size", "20x10", "--set", "image.width=30"})));
  ASSERT_TRUE(succeeds(render("b", {"--set", "image.width=30", "--size", "20x10"})));
  EXPECT_EQ(picture("a/final.png").width_px, 30);
  EXPECT_EQ(picture("a/final.png").height_px, 10);
  EXPECT_EQ(folder_content(file("a")), folder_content(file("b")));
}

TEST_F(Render, a_style_draws_strokes_and_set_changes_them) {
  ASSERT_TRUE(succeeds(render("a", {"--style", "pencil"})));
  ASSERT_TRUE(succeeds(render("b", {"--style", "pencil", "--set", "stroke.width=6"})));
  ASSERT_TRUE(succeeds(render("c", {"--set", "stroke.width=6", "--style", "pencil"})));
  EXPECT_NE(picture("a/final.png"), picture("b/final.png"));
  EXPECT_EQ(picture("b/final.png"), picture("c/final.png"));
}

TEST_F(Render, a_misspelt_style_suggests_the_nearest) {
  EXPECT_TRUE(
      is_input_error(render("out", {"--style", "pensil"}), {"--style", "pensil", "did you mean 'pencil'?"}));
}

TEST_F(Render, an_image_in_a_style_is_made_again_from_itself) {
  ASSERT_TRUE(succeeds(render("a", {"--style", "charcoal"})));
  ASSERT_TRUE(succeeds(inkbench({"render", "--from", "a/final.png", "--out", "b"})));
  EXPECT_EQ(picture("a/final.png"), picture("b/final.png"));
}

TEST_F(Render, the_last_set_of_a_key_wins) {
  EXPECT_EQ(final_with({"camera.fov=60", "camera.fov=30"}), final_with({"camera.fov=30"}));
}

TEST_F(Render, vectors_and_components_are_set_in_each_spelling) {
  const Picture expected = final_with({"camera.eye=[1, 2, 9]"});
  EXPECT_NE(expected, final_with({}));
  EXPECT_EQ(final_with({"camera.eye=1, 2, 9"}), expected);
  EXPECT_EQ(final_with({"camera.eye=[1.0,2.0,9.0]"}), expected);
  EXPECT_EQ(final_with({"camera.eye.x=1", "camera.eye.y=2", "camera.eye.z=9"}), expected);
}

TEST_F(Render, colours_are_set_in_each_spelling) {
  const Picture expected = final_with({"ink.colour=#ff0000"});
  EXPECT_NE(expected, final_with({}));
  EXPECT_EQ(final_with({"ink.colour=\"#FF0000\""}), expected);
  EXPECT_EQ(final_with({"ink.colour=[1, 0, 0]"}), expected);
  EXPECT_EQ(final_with({"ink.colour.r=1"}), expected);
}

TEST_F(Render, choices_and_switches_are_set_by_name) {
  EXPECT_NE(final_with({"model.ball.shape=torus"}), final_with({}));
  EXPECT_EQ(final_with({"model.ball.shape=\"torus\""}), final_with({"model.ball.shape=torus"}));
  EXPECT_NE(final_with({"model.ball.visible=false"}), final_with({}));
}

TEST_F(Render, eight_bit_precision_shows_in_the_raw_values) {
  ASSERT_TRUE(
      succeeds(render("out", {"--set", "image.precision=unorm8", "--buffers", "depth", "--format", "exr"})));
  const Image depth = read_image(file("out/depth.exr"));
  for (const float value : depth.samples) ASSERT_NEAR(value * 255.0F, std::round(value * 255.0F), 1e-4F);
}

TEST_F(Render, paths_work_relative_and_absolute) {
  ASSERT_TRUE(succeeds(inkbench({"render", "--scene", "./scene.toml", "--out", "here"})));
  ASSERT_TRUE(succeeds(inkbench({"render", "--scene", file("scene.toml"), "--out", file("there")})));
  fs::create_directories(file("sub"));
  CommandOptions below;
  below.working_folder = file("sub");
  ASSERT_TRUE(succeeds(inkbench({"render", "--scene", "../scene.toml", "--out", "../elsewhere"}, below)));
  const FolderContent here = folder_content(file("here"));
  EXPECT_EQ(here, folder_content(file("there")));
  EXPECT_EQ(here, folder_content(file("elsewhere")));
}

TEST_F(Render, same_command_gives_the_same_bytes) {
  for (const std::string format : {"png", "exr"}) {
    ASSERT_TRUE(succeeds(render("a", {"--buffers", "all", "--format", format})));
    ASSERT_TRUE(succeeds(render("b", {"--buffers", "all", "--format", format})));
  }
  EXPECT_EQ(folder_content(file("a")), folder_content(file("b")));
}

TEST_F(Render, image_carries_version_and_all_parameters) {
  const std::vector<std::string> changes{
      "--set", "combine.k_depth=0.00123", "--set", "ink.colour=#102030", "--buffers", "depth"};
  for (const std::string format : {"png", "exr"}) {
    std::vector<std::string> arguments = changes;
    arguments.insert(arguments.end(), {"--format", format});
    ASSERT_TRUE(succeeds(render("out", arguments)));
    const fs::path image = file("out/depth." + format);
    EXPECT_EQ(read_image_text(image, "inkbench:version"), INKBENCH_VERSION);
    EXPECT_EQ(read_image_text(image, "inkbench:buffer"), "depth");
    const std::string text = read_image_text(image, "inkbench:settings");
    EXPECT_THAT(text, HasSubstr("k_depth = 0.00123"));
    Settings carried = parse_settings(text, "metadata", "/");
    EXPECT_EQ(settings_text(carried), text) << "every parameter is in the text";
    Settings expected = load_settings(file("scene.toml"));
    set_param_text(expected, "combine.k_depth", "0.00123", "");
    set_param_text(expected, "ink.colour", "#102030", "");
    EXPECT_EQ(text, settings_text(expected));
  }
}

TEST_F(Render, from_an_image_makes_the_same_image_again) {
  ASSERT_TRUE(succeeds(render(
      "first", {"--size", "90x50", "--set", "combine.k_normal=0.004", "--buffers", "final,normal_edges"})));
  fs::rename(file("scene.toml"), file("gone.toml"));
  for (const std::string name : {"final.png", "normal_edges.png"}) {
    ASSERT_TRUE(succeeds(inkbench({"render", "--from", "first/" + name, "--out", "again"})));
    EXPECT_EQ(content_of(file("first/" + name)), content_of(file("again/" + name)))
        << "its own buffer is the default";
  }
}

TEST_F(Render, from_an_exr_and_with_changes_works_too) {
  ASSERT_TRUE(succeeds(render("first", {"--format", "exr", "--buffers", "depth"})));
  ASSERT_TRUE(succeeds(render("expected", {"--set", "camera.fov=60"})));
  ASSERT_TRUE(succeeds(inkbench({"render", "--from", "first/depth.exr", "--set", "camera.fov=60", "--buffers",
                                 "final", "--out", "again"})));
  EXPECT_EQ(folder_content(file("expected")), folder_content(file("again")));
}

TEST_F(Render, from_other_files_says_what_is_needed) {
  write_png(file("plain.png"), Picture(4, 4, 3, 100), {});
  write("text.png", "not a picture");
  EXPECT_TRUE(is_input_error(inkbench({"render", "--from", "plain.png", "--out", "out"}),
                             {"plain.png", "parameters", "render"}));
  EXPECT_TRUE(is_input_error(inkbench({"render", "--from", "text.png", "--out", "out"}), {"text.png"}));
  EXPECT_TRUE(is_input_error(inkbench({"render", "--from", "none.png", "--out", "out"}),
                             {"none.png", "no such file"}));
  EXPECT_FALSE(fs::exists(file("out")));
}

}  // namespace
}  // namespace inkbench
