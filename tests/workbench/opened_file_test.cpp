// SPDX-License-Identifier: MIT
// Ramp files, and what a dropped file is: told by content, with an error that helps where it is nothing.
#include "app/workbench/opened_file.h"

#include "app/workbench/presets.h"
#include "app/workbench/ramp_edit.h"
#include "app/workbench/ramp_file.h"
#include "pipeline/export.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class OpenedFileTest : public testing::Test {
 protected:
  fs::path path(const std::string& name) const { return folder_.path() / name; }
  std::string error(const fs::path& file) const {
    return error_of([&] { open_file(file); });
  }

  TemporaryFolder folder_;
};

Ramp smooth_ramp() {
  return {{{0.1F, glm::vec3(0.25F, 0.5F, 0.1F / 3.0F), false}, {0.5F, glm::vec3(1), true}}, ""};
}

using RampFile = OpenedFileTest;

TEST_F(RampFile, as_toml_comes_back_exactly) {
  save_ramp(path("r.toml"), smooth_ramp());
  EXPECT_EQ(load_ramp(path("r.toml")), smooth_ramp());
}

TEST_F(RampFile, as_an_image_comes_back_as_its_texels) {
  for (const auto& [name, tolerance] : {std::pair{"r.png", 0.501F / 255.0F}, {"r.exr", 0.0F}}) {
    save_ramp(path(name), smooth_ramp());
    const Ramp back = load_ramp(path(name));
    EXPECT_EQ(back.image, path(name).string());
    const std::vector<glm::vec3> expected = ramp_table(smooth_ramp());
    const std::vector<glm::vec3> actual = ramp_table(back);
    for (size_t i = 0; i < expected.size(); ++i) {
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(actual[i][c], expected[i][c], tolerance) << name << " " << i;
    }
  }
}

TEST_F(RampFile, of_an_image_ramp_as_toml_holds_its_stops) {
  save_ramp(path("r.exr"), even_bands(smooth_ramp(), 4));
  save_ramp(path("r.toml"), load_ramp(path("r.exr")));
  EXPECT_EQ(load_ramp(path("r.toml")).stops.size(), 4U);
}

TEST_F(RampFile, other_endings_are_errors) {
  EXPECT_THAT(error_of([&] { save_ramp(path("r.jpg"), smooth_ramp()); }), HasSubstr("name it .toml"));
  EXPECT_THAT(error_of([&] { save_ramp(path("r"), smooth_ramp()); }), HasSubstr("name it .toml"));
}

TEST_F(RampFile, what_is_wrong_in_one_is_named_by_line) {
  const auto load = [&](const std::string& content) {
    return error_of([&] { load_ramp(folder_.write("r.toml", content)); });
  };
  const std::string at = path("r.toml").string();
  EXPECT_THAT(load("\nstops = 1"), StartsWith(at + ":2: stops is a number"));
  EXPECT_THAT(load("stops = \"a.png\""), StartsWith(at + ":1: stops is the text"));
  EXPECT_THAT(load("stops = []"), StartsWith(at + ":1: stops is a list of 0"));
  EXPECT_THAT(load("stops = [{position = 2, colour = 1}]"), HasSubstr("positions rise from 0 to 1"));
  EXPECT_THAT(load("stops = [{position = 0, colour = 1}]\nname = 1"),
              StartsWith(at + ":2: unknown entry 'name'"));
  EXPECT_THAT(load("name = 1"), HasSubstr("holds no ramp"));
}

TEST_F(OpenedFileTest, an_exported_image_gives_its_parameters) {
  Settings settings = paper_settings();
  settings.combine.k_depth = 0.5F;
  write_png(path("a.png"), Picture(4, 4, 3), export_text(settings, BufferName::depth));
  write_exr(path("b.exr"), Image(4, 4, 1), export_text(settings, BufferName::normal));
  // The name says nothing.
  fs::rename(path("a.png"), path("picture"));
  for (const auto& [name, buffer] :
       {std::pair{"picture", BufferName::depth}, {"b.exr", BufferName::normal}}) {
    const OpenedFile file = open_file(path(name));
    EXPECT_EQ(file.kind, FileKind::exported_image);
    EXPECT_EQ(file.buffer, buffer);
    EXPECT_EQ(text(*file.settings), text(settings));
  }
}

TEST_F(OpenedFileTest, an_exported_image_with_damaged_parameters_is_an_error) {
  write_png(path("a.png"), Picture(4, 4, 3),
            {{"inkbench:settings", "[combine]\nk_depth = 99\n"}, {"inkbench:buffer", "final"}});
  EXPECT_THAT(error(path("a.png")), HasSubstr("a.png (metadata):2: combine.k_depth = 99"));
}

TEST_F(OpenedFileTest, another_image_can_be_a_ramp) {
  write_png(path("a.png"), Picture(4, 4, 3, 128), {});
  const OpenedFile file = open_file(path("a.png"));
  EXPECT_EQ(file.kind, FileKind::ramp_image);
  EXPECT_EQ(file.ramp->image, path("a.png").string());
  // A format without a signature of its own.
  folder_.write("b.ppm", "P6\n1 1\n255\n" + std::string("\x00\x80\xff", 3));
  EXPECT_EQ(open_file(path("b.ppm")).kind, FileKind::ramp_image);
}

TEST_F(OpenedFileTest, a_grid_gives_its_study) {
  write_png(path("grid.png"), Picture(4, 4, 3),
            {{"inkbench:spec", "title = \"T\"\n[[axis]]\nkey = \"camera.fov\"\nvalues = [20, 30]\n"}});
  const OpenedFile file = open_file(path("grid.png"));
  EXPECT_EQ(file.kind, FileKind::study);
  EXPECT_EQ(file.study->axes.at(0).values.size(), 2U);
}

TEST_F(OpenedFileTest, toml_files_are_told_apart) {
  const PresetStore store(folder_.path());
  store.save("mine", paper_settings());
  save_ramp(path("ramp.toml"), smooth_ramp());
  const auto kind = [&](const fs::path& file) { return open_file(file).kind; };
  EXPECT_EQ(kind(path("mine.toml")), FileKind::preset);
  EXPECT_EQ(kind(path("ramp.toml")), FileKind::ramp);
  EXPECT_EQ(kind(project_file("data/scenes/paper.toml")), FileKind::scene);
  EXPECT_EQ(kind(project_file("data/scenes/shapes.toml")), FileKind::scene);
  EXPECT_EQ(kind(folder_.write("s.toml", "[scene]\nambient = 0.5\n")), FileKind::scene);
  EXPECT_EQ(kind(folder_.write("t.toml", "scene = \"s.toml\"\n")), FileKind::study);
  EXPECT_EQ(text(*open_file(path("mine.toml")).settings), text(paper_settings()));
}

TEST_F(OpenedFileTest, every_bundled_scene_and_study_is_told) {
  int scenes = 0;
  int studies = 0;
  for (const char* folder : {"data/scenes", "studies", "studies/figures"}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(project_file(folder))) {
      if (entry.path().extension() != ".toml") continue;
      const bool is_scene = std::string_view(folder) == "data/scenes";
      EXPECT_EQ(open_file(entry.path()).kind, is_scene ? FileKind::scene : FileKind::study) << entry.path();
      ++(is_scene ? scenes : studies);
    }
  }
  EXPECT_GE(scenes, 3);
  EXPECT_GE(studies, 15);
}

TEST_F(OpenedFileTest, a_mesh_is_told_by_its_ending) {
  EXPECT_EQ(open_file(folder_.write("a.OBJ", "v 0 0 0\n")).kind, FileKind::mesh);
  EXPECT_EQ(open_file(folder_.write("a.stl", "BM\xff\xfe")).kind, FileKind::mesh);
}

TEST_F(OpenedFileTest, damage_is_named_by_file_and_line) {
  EXPECT_THAT(error(folder_.write("a.toml", "[combine]\nk_dept = 1\n")),
              HasSubstr("a.toml:2: unknown parameter 'combine.k_dept'; did you mean"));
  EXPECT_THAT(error(folder_.write("a.toml", "title = \n")), HasSubstr("a.toml:1: not valid TOML"));
  EXPECT_THAT(error(folder_.write("a.toml", "show = [\"finl\"]\n")),
              HasSubstr("a.toml:1: unknown buffer 'finl'"));
  EXPECT_THAT(error(folder_.write("a.toml", "[camera]\neye = 0\ntarget = 0\n")), HasSubstr("camera.eye"));
  EXPECT_THAT(error(folder_.write("a.png", "\x89PNG\r\n\x1a\n")), HasSubstr("a.png: is cut off"));
}

TEST_F(OpenedFileTest, what_is_nothing_we_know_is_an_error_that_says_what_is) {
  for (const std::string& content : {std::string("dear diary\n"), std::string("\0\x01\x02", 3),
                                     std::string("%PDF-1.4"), std::string("\xff\xff\xff")}) {
    EXPECT_THAT(error(folder_.write("thing", content)),
                AllOf(HasSubstr("is no file that inkbench can open"), HasSubstr("inkbench opens images")));
  }
  EXPECT_THAT(error(folder_.write("empty.png", "")), HasSubstr("is empty"));
  EXPECT_THAT(error(folder_.path()), HasSubstr("is a folder"));
  EXPECT_THAT(error(path("none.png")), HasSubstr("no such file"));
  EXPECT_THAT(error("/dev/null"), HasSubstr("is not a regular file"));
  EXPECT_THAT(error(folder_.write("\xff.toml", "")), HasSubstr("not UTF-8"));
}

}  // namespace
}  // namespace inkbench
