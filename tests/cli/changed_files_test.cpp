// SPDX-License-Identifier: MIT
// Images know what held the files that they were made from: `--from` tells of those that are others now.
#include "pipeline/image/image_file.h"
#include "tests/cli/study_fixture.h"
#include "tests/cli/written_mesh.h"

namespace inkbench {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class ChangedFiles : public StudyTest {
 protected:
  ChangedFiles() {
    write("part.off", cube_off(1, 0));
    write_ramp(100);
    write("own.toml",
          "base = \"scene.toml\"\n[ramp]\ndiffuse = \"ramp.png\"\n"
          "[[model]]\nname = \"box\"\nshape = \"mesh\"\nmesh = \"part.off\"\n");
    draw("png");
  }
  void draw(const std::string& format) const {
    EXPECT_TRUE(succeeds(inkbench({"render", "--scene", "own.toml", "--format", format, "--out", "first"})));
  }
  void write_ramp(uint8_t grey) const { write_png(file("ramp.png"), Picture(4, 1, 3, grey), {}); }
  /// What is told on stderr.
  std::string told(const std::string& image, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"render", "--from", image, "--out", "again"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandResult result = inkbench(arguments);
    EXPECT_TRUE(succeeds(result));
    return result.err;
  }
};

TEST_F(ChangedFiles, nothing_is_told_while_they_hold_the_same) {
  write("part.off", cube_off(1, 0));  // another time
  EXPECT_THAT(told("first/final.png"), IsEmpty());
}

TEST_F(ChangedFiles, mesh_and_ramp_that_hold_something_else_are_told) {
  draw("exr");
  write("part.off", cube_off(1.5, 0));
  for (const char* image : {"first/final.png", "first/final.exr"}) {
    const std::string text = told(image);
    EXPECT_THAT(text,
                HasSubstr("note: " + file("part.off").string() + " (model.box.mesh) is another file now"));
    EXPECT_THAT(text, HasSubstr(image));
    EXPECT_THAT(text, Not(HasSubstr("ramp.png")));
  }
  write_ramp(101);
  EXPECT_THAT(told("first/final.png"), HasSubstr("ramp.png (ramp.diffuse) is another file now"));
}

TEST_F(ChangedFiles, a_file_that_is_replaced_or_not_drawn_is_not_told) {
  write("part.off", cube_off(1.5, 0));
  write("other.off", cube_off(2, 0));
  EXPECT_THAT(told("first/final.png", {"--mesh", "other.off"}), IsEmpty());
  EXPECT_THAT(told("first/final.png", {"--set", "model.box.visible=false"}), IsEmpty());
}

TEST_F(ChangedFiles, every_command_and_a_studys_pictures_know) {
  write("s.toml", "scene = \"own.toml\"\nshow = [\"final\"]\n");
  ASSERT_TRUE(succeeds(study("s", "out")));
  write("part.off", cube_off(1.5, 0));
  EXPECT_THAT(told("out/cells/0001_final.png"), HasSubstr("part.off (model.box.mesh)"));
  const CommandResult measured = inkbench({"measure", "--from", "first/final.png", "--json"});
  EXPECT_TRUE(succeeds(measured));
  EXPECT_THAT(measured.err, HasSubstr("part.off (model.box.mesh)"));
}

TEST_F(ChangedFiles, an_image_of_an_earlier_version_tells_nothing) {
  ImageText text;
  for (const char* entry : {"inkbench:version", "inkbench:buffer", "inkbench:settings"})
    text[entry] = read_image_text(file("first/final.png"), entry);
  write_png(file("older.png"), Picture(64, 48, 3), text);
  write("part.off", cube_off(1.5, 0));
  EXPECT_THAT(told("older.png"), IsEmpty());
}

}  // namespace
}  // namespace inkbench
