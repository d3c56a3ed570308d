// SPDX-License-Identifier: MIT
// A session as text: it comes back equal, and what is broken in it is named by line.
#include "app/workbench/session.h"

#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

Session busy_session() {
  Session session = first_session();
  session.settings.combine.k_depth = 0.1F / 3.0F;
  session.layout = {.width_px = 1000,
                    .maximised = true,
                    .left = 0.3F,
                    .show_log = false,
                    .left_tab = LeftTab::history,
                    .theme = Theme::light};
  session.recent = {"/a/b.toml", "/with \"quotes\"/ü.png"};
  session.bookmarks = {{"front", 1, {}}, {"front", 0, {.eye = {1, 2, 3}, .fov = 60}}, {"", 9, {}}};
  return session;
}

TEST(Session, comes_back_equal) {
  const Session session = busy_session();
  const Session again = parse_session(session_text(session), "s");
  EXPECT_EQ(session_text(again), session_text(session));
  EXPECT_EQ(text(again.settings), text(session.settings));
  EXPECT_EQ(again.scene, session.scene);
  EXPECT_EQ(again.recent, session.recent);
  EXPECT_EQ(again.layout, session.layout);
  ASSERT_THAT(again.bookmarks, SizeIs(3));
  EXPECT_EQ(again.bookmarks[1].name, "front");
  EXPECT_EQ(again.bookmarks[0].key, 1);
  EXPECT_EQ(again.bookmarks[2].key, 9);
  EXPECT_EQ(again.bookmarks[1].camera.eye, glm::vec3(1, 2, 3));
}

TEST(Session, a_first_one_is_the_papers_scene) {
  EXPECT_EQ(text(first_session().settings), text(paper_settings()));
  EXPECT_EQ(first_session().scene, project_file("data/scenes/paper.toml"));
  EXPECT_TRUE(first_session().layout.show_welcome);
}

TEST(Session, what_it_leaves_out_has_its_default) {
  const Session session = parse_session("[session.layout]\nwidth_px = 640\n", "s");
  EXPECT_EQ(session.layout.width_px, 640);
  EXPECT_EQ(session.layout.height_px, WindowLayout{}.height_px);
  EXPECT_EQ(text(session.settings), text(Settings{}));
}

TEST(Session, what_is_broken_is_named_by_line) {
  const auto error = [](const std::string& content) {
    return error_of([&] { parse_session(content, "s.toml"); });
  };
  EXPECT_THAT(error("[session]\nscene = 1"), StartsWith("s.toml:2: scene is a number"));
  EXPECT_THAT(error("[session]\nrecent = 1"), StartsWith("s.toml:2: recent is a number"));
  EXPECT_THAT(error("session = 1"), StartsWith("s.toml:1: session is a number"));
  EXPECT_THAT(error("[session.layout]\nwidth_px = 5"), StartsWith("s.toml:2: session.layout.width_px = 5"));
  EXPECT_THAT(error("[session.layout]\ntheme = \"grey\""), HasSubstr("one of: dark, light"));
  EXPECT_THAT(error("[[session.bookmark]]\nfov = 500"), StartsWith("s.toml:2: session.bookmark.fov = 500"));
  EXPECT_THAT(error("[[session.bookmark]]\nkey = 10"), StartsWith("s.toml:2: session.bookmark.key = 10"));
  EXPECT_THAT(error("[session]\n[combine]\nk_depth = 9"), StartsWith("s.toml:3: combine.k_depth = 9"));
  EXPECT_THAT(error("[session]\nscene = \n"), StartsWith("s.toml:2: not valid TOML"));
}

TEST(Session, what_a_newer_version_wrote_is_left_out_and_named) {
  std::vector<std::string> left_out;
  const Session session = parse_session(R"([session]
scene = "/a.toml"
tabs = [1]
[session.layout]
width_px = 640
dock = "left"
[[session.bookmark]]
name = "front"
lens = 3
[combine]
glow = 2
k_depth = 0.5
[fog]
near = 1
[camera.bokeh]
size = 1
[[model]]
name = "ball"
shape = "sphere"
fur = true
material.sheen = 1
material.exponent = 9
)",
                                        "s", &left_out);
  EXPECT_THAT(left_out, ElementsAre("session.tabs (line 3)", "session.layout.dock (line 6)",
                                    "session.bookmark.lens (line 9)", "combine.glow (line 11)",
                                    "fog (line 13)", "camera.bokeh (line 15)", "model.ball.fur (line 20)",
                                    "model.ball.material.sheen (line 21)"));
  EXPECT_EQ(session.scene, "/a.toml");
  EXPECT_EQ(session.layout.width_px, 640);
  EXPECT_EQ(session.bookmarks.at(0).name, "front");
  EXPECT_EQ(session.settings.combine.k_depth, 0.5F);
  EXPECT_EQ(session.settings.models.at(0).material.exponent, 9.0F);
  parse_session(session_text(busy_session()), "s", &left_out);
  EXPECT_THAT(left_out, IsEmpty());
}

TEST(Session, recent_files_are_each_there_once_newest_first) {
  Session session;
  for (const char* file : {"/a", "/b", "/c", "/x/../b"}) add_recent(session, file);
  EXPECT_THAT(session.recent, ElementsAre("/b", "/c", "/a"));
  for (int i = 0; i < 50; ++i) add_recent(session, "/f" + std::to_string(i));
  EXPECT_THAT(session.recent, SizeIs(kMaxRecent));
  EXPECT_EQ(session.recent.front(), "/f49");
}

TEST(Session, recent_files_that_are_gone_are_dropped) {
  const TemporaryFolder folder;
  Session session;
  session.recent = {"/none", folder.write("here", ""), folder.path()};
  drop_missing_recent(session);
  EXPECT_THAT(session.recent, ElementsAre(folder.path() / "here"));
}

TEST(Session, paths_that_are_not_utf8_are_left_out) {
  Session session;
  session.scene = "/\xff.toml";
  session.recent = {"/a", "/\xff"};
  const Session again = parse_session(session_text(session), "s");
  EXPECT_TRUE(again.scene.empty());
  EXPECT_THAT(again.recent, ElementsAre("/a"));
}

TEST(Session, lists_have_bounds) {
  Session session;
  session.recent.assign(100, "/a");
  session.bookmarks.resize(1000);
  const Session again = parse_session(session_text(session), "s");
  EXPECT_THAT(again.recent, SizeIs(kMaxRecent));
  EXPECT_THAT(again.bookmarks, SizeIs(kMaxBookmarks));
}

}  // namespace
}  // namespace inkbench
