// SPDX-License-Identifier: MIT
// Presets: what is saved comes back equal; bad names and bad files are errors that leave the rest alone.
#include "app/workbench/presets.h"

#include "app/workbench/user_folder.h"
#include "tests/unit/file_size_limit.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

Settings tuned_settings() {
  Settings settings = paper_settings();
  settings.combine.k_depth = 0.1F / 3.0F;
  settings.models[0].mesh = "/tmp/a \"quoted\" name.ply";
  settings.ramp.specular.stops[0].stepped = false;
  settings.lights.emplace_back().name = "fill";
  return settings;
}

TEST(Presets, come_back_equal) {
  const TemporaryFolder folder;
  const PresetStore store(folder.path() / "not" / "there" / "yet");
  const auto path = store.save("Fine lines", tuned_settings());
  EXPECT_EQ(path, store.folder() / "Fine lines.toml");
  EXPECT_EQ(text(store.load("Fine lines")), text(tuned_settings()));
  EXPECT_EQ(text(load_settings(path)), text(tuned_settings())) << "a preset is a scene file";
  EXPECT_THAT(read_file(path), StartsWith(std::string(kPresetMark)));
}

TEST(Presets, are_listed_by_name) {
  const TemporaryFolder folder;
  const PresetStore store(folder.path());
  EXPECT_THAT(PresetStore(folder.path() / "none").list(), IsEmpty());
  for (const char* name : {"zebra", "Äpfel", "a.b", "10 %"}) store.save(name, tuned_settings());
  folder.write("notes.txt", "");
  folder.write("half.toml.part1-1", "");
  folder.write("folder.toml/x", "");
  folder.write("broken.toml", "[[");
  EXPECT_THAT(store.list(), ElementsAre("10 %", "a.b", "broken", "zebra", "Äpfel"));
  EXPECT_TRUE(store.contains("a.b"));
  EXPECT_FALSE(store.contains("folder"));
}

TEST(Presets, of_two_windows_are_all_there) {
  const TemporaryFolder folder;
  const PresetStore a(folder.path());
  const PresetStore b(folder.path());
  EXPECT_THAT(b.list(), IsEmpty());
  a.save("of a", paper_settings());
  b.save("of b", paper_settings());
  EXPECT_THAT(a.list(), ElementsAre("of a", "of b"));
  EXPECT_EQ(b.list(), a.list());
}

TEST(Presets, are_not_overwritten_unless_asked) {
  const TemporaryFolder folder;
  const PresetStore store(folder.path());
  store.save("one", tuned_settings());
  EXPECT_EQ(error_of([&] { store.save("one", paper_settings()); }),
            "preset: there is one named 'one' already; overwrite it or choose another name");
  EXPECT_EQ(text(store.load("one")), text(tuned_settings()));
  store.save("one", paper_settings(), true);
  EXPECT_EQ(text(store.load("one")), text(paper_settings()));
}

TEST(Presets, names_that_cannot_be_files_are_errors) {
  const TemporaryFolder folder;
  const PresetStore store(folder.path() / "presets");
  for (const std::string& name :
       {std::string(), std::string("../up"), std::string("a/b"), std::string("a\\b"), std::string(".hidden"),
        std::string(".."), std::string(" a"), std::string("a "), std::string("a."), std::string("a\nb"),
        std::string("a\0b", 3), std::string("a:b"), std::string("\xff\xfe"), std::string(101, 'x')}) {
    EXPECT_THAT(error_of([&] { store.save(name, tuned_settings()); }),
                AllOf(StartsWith("preset: the name "), HasSubstr("use letters")));
    EXPECT_THAT(error_of([&] { store.load(name); }), StartsWith("preset: the name "));
    EXPECT_THAT(error_of([&] { store.remove(name); }), StartsWith("preset: the name "));
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "presets"));
}

TEST(Presets, a_missing_one_is_an_error_with_the_nearest_name) {
  const TemporaryFolder folder;
  const PresetStore store(folder.path());
  store.save("fine lines", tuned_settings());
  EXPECT_EQ(error_of([&] { store.load("fine line"); }),
            "preset: there is none named 'fine line'; did you mean 'fine lines'?");
  EXPECT_THAT(error_of([&] { store.remove("fine line"); }), HasSubstr("did you mean"));
}

TEST(Presets, damage_is_named_by_file_and_line_and_touches_nothing) {
  const TemporaryFolder folder;
  const PresetStore store(folder.path());
  store.save("good", tuned_settings());
  const auto bad = folder.write("bad.toml", "[combine]\nk_depth = 7\n");
  EXPECT_THAT(error_of([&] { store.load("bad"); }), StartsWith(bad.string() + ":2: combine.k_depth = 7"));
  folder.write("bad.toml", "[combine]\nk_depth = \n");
  EXPECT_THAT(error_of([&] { store.load("bad"); }), StartsWith(bad.string() + ":2: not valid TOML"));
  EXPECT_EQ(text(store.load("good")), text(tuned_settings()));
  EXPECT_EQ(read_file(bad), "[combine]\nk_depth = \n");
}

TEST(Presets, are_deleted) {
  const TemporaryFolder folder;
  const PresetStore store(folder.path());
  store.save("one", tuned_settings());
  store.save("two", tuned_settings());
  store.remove("one");
  EXPECT_THAT(store.list(), ElementsAre("two"));
}

TEST(Presets, a_failed_save_keeps_the_old_one) {
  const TemporaryFolder folder;
  const PresetStore store(folder.path());
  store.save("one", tuned_settings());
  {
    const FileSizeLimit full(64);
    error_of([&] { store.save("one", paper_settings(), true); }, ErrorKind::work);
  }
  EXPECT_THAT(store.list(), ElementsAre("one"));
  EXPECT_EQ(text(store.load("one")), text(tuned_settings()));
}

TEST(Presets, comparing_shows_just_what_differs) {
  Settings a = paper_settings();
  Settings b = a;
  Settings c = a;
  b.combine.k_depth = 0.001F;
  c.combine.k_depth = 0.001F;
  c.ramp.diffuse.stops[0].position = 0.125F;
  c.lights.clear();
  const std::vector<NamedSettings> all{{"paper", a}, {"fine", b}, {"ä", c}};
  const PresetTable table = compare_settings(all);
  EXPECT_THAT(table.names, ElementsAre("paper", "fine", "ä"));
  ASSERT_EQ(table.rows.size(), 8U) << "k_depth, a ramp, six of the light";
  EXPECT_EQ(table_text(table),
            "parameter            paper             fine              ä\n"
            "light.key.type       directional       directional       -\n"
            "light.key.direction  0.55, 0.75, 0.65  0.55, 0.75, 0.65  -\n"
            "light.key.position   0, 5, 0           0, 5, 0           -\n"
            "light.key.ambient    0.1, 0.1, 0.1     0.1, 0.1, 0.1     -\n"
            "light.key.diffuse    0.9, 0.9, 0.9     0.9, 0.9, 0.9     -\n"
            "light.key.specular   0.8, 0.8, 0.8     0.8, 0.8, 0.8     -\n"
            "ramp.diffuse         4 stops (1)       4 stops (1)       4 stops (2)\n"
            "combine.k_depth      0.003             0.001             0.001\n");
}

TEST(Presets, comparing_shows_all_digits_where_four_look_the_same) {
  Settings b = paper_settings();
  b.combine.k_depth = 0.0030000010F;
  const std::vector<NamedSettings> all{{"a", paper_settings()}, {"b", b}};
  EXPECT_EQ(table_text(compare_settings(all)),
            "parameter        a      b\n"
            "combine.k_depth  0.003  0.003000001\n");
}

TEST(Presets, comparing_equal_ones_shows_nothing) {
  const std::vector<NamedSettings> all{{"a", tuned_settings()}, {"b", tuned_settings()}};
  EXPECT_EQ(table_text(compare_settings(all)), "no parameter differs\n");
  EXPECT_TRUE(compare_settings({}).rows.empty());
}

class UserFolder : public testing::Test {
 protected:
  void SetUp() override { unsetenv("XDG_CONFIG_HOME"); }
  void TearDown() override {
    setenv("HOME", home_.c_str(), 1);
    config_.empty() ? unsetenv("XDG_CONFIG_HOME") : setenv("XDG_CONFIG_HOME", config_.c_str(), 1);
  }

 private:
  static std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
  }
  std::string home_ = variable("HOME"), config_ = variable("XDG_CONFIG_HOME");
};

TEST_F(UserFolder, follows_the_xdg_specification) {
  setenv("HOME", "/home/someone", 1);
  EXPECT_EQ(user_folder(), "/home/someone/.config/inkbench");
  setenv("XDG_CONFIG_HOME", "/elsewhere", 1);
  EXPECT_EQ(user_folder(), "/elsewhere/inkbench");
  setenv("XDG_CONFIG_HOME", "relative", 1);
  EXPECT_EQ(user_folder(), "/home/someone/.config/inkbench");
}

TEST_F(UserFolder, without_a_home_is_an_error) {
  unsetenv("HOME");
  EXPECT_THAT(error_of([] { user_folder(); }, ErrorKind::work), StartsWith("HOME: is not set"));
}

TEST(Presets, keep_marks_beside_them_until_they_are_saved_without) {
  const TemporaryFolder folder;
  const PresetStore store(folder.path());
  const PaintedMarks marks{{{}, 3, 1, "wuW"}};
  store.save("one", paper_settings(), false, marks);
  ASSERT_TRUE(store.marks("one"));
  EXPECT_TRUE(same_marks(*store.marks("one"), marks));
  EXPECT_THAT(store.list(), ElementsAre("one"));
  store.save("one", paper_settings(), true);
  EXPECT_FALSE(store.marks("one"));
}

}  // namespace
}  // namespace inkbench
