// SPDX-License-Identifier: MIT
// Sessions on the disk: clean exits, crashes, damaged files, several windows at once.
#include "app/workbench/session_store.h"

#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "tests/unit/file_size_limit.h"
#include "tests/workbench/workbench_support.h"

namespace inkbench {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Session session_with_k(float k) {
  Session session = first_session();
  session.settings.combine.k_depth = k;
  return session;
}

class SessionStoreTest : public testing::Test {
 protected:
  fs::path path() const { return folder_.path(); }
  std::string file(const std::string& name) const { return read_file(path() / name); }

  /// A window that works and dies.
  void crash_with(float k) const {
    SessionStore store(path());
    store.load();
    store.autosave(session_with_k(k));
  }

  TemporaryFolder folder_;
};

TEST_F(SessionStoreTest, a_first_start_is_the_papers_scene_without_notes) {
  SessionStore store(path() / "not" / "there");
  EXPECT_EQ(text(store.load().settings), text(paper_settings()));
  EXPECT_THAT(store.notes(), IsEmpty());
  EXPECT_THAT(store.unsaved(), IsEmpty());
}

TEST_F(SessionStoreTest, what_was_closed_comes_back) {
  {
    SessionStore store(path());
    store.load();
    EXPECT_TRUE(store.autosave(session_with_k(0.5F)));
    store.close(session_with_k(0.25F));
  }
  SessionStore store(path());
  EXPECT_EQ(session_text(store.load()), session_text(session_with_k(0.25F)));
  EXPECT_THAT(store.unsaved(), IsEmpty());
  EXPECT_THAT(store.notes(), IsEmpty());
}

TEST_F(SessionStoreTest, unsaved_work_is_offered_after_a_crash_until_it_is_forgotten) {
  SessionStore(path()).close(session_with_k(0.25F));
  crash_with(0.5F);
  {
    SessionStore store(path());
    EXPECT_EQ(store.load().settings.combine.k_depth, 0.25F);
    ASSERT_THAT(store.unsaved(), SizeIs(1));
    EXPECT_EQ(session_text(store.unsaved()[0].session), session_text(session_with_k(0.5F)));
    store.close(session_with_k(0.25F));
  }
  {
    SessionStore store(path());
    ASSERT_THAT(store.unsaved(), SizeIs(1)) << "it was neither restored nor refused";
    store.forget_unsaved(0);
    EXPECT_THAT(store.unsaved(), IsEmpty());
  }
  EXPECT_THAT(SessionStore(path()).unsaved(), IsEmpty());
}

TEST_F(SessionStoreTest, a_window_without_changes_leaves_nothing_behind) {
  {
    SessionStore store(path());
    const Session session = store.load();
    EXPECT_FALSE(store.autosave(session));
  }
  EXPECT_THAT(SessionStore(path()).unsaved(), IsEmpty());
}

TEST_F(SessionStoreTest, autosaves_only_what_has_changed) {
  SessionStore store(path());
  store.load();
  EXPECT_TRUE(store.autosave(session_with_k(0.5F)));
  EXPECT_FALSE(store.autosave(session_with_k(0.5F)));
  EXPECT_TRUE(store.autosave(session_with_k(0.6F)));
}

TEST_F(SessionStoreTest, a_killed_process_leaves_its_work) {
  const pid_t child = fork();
  if (child == 0) {
    SessionStore store(path());
    store.load();
    store.autosave(session_with_k(0.5F));
    raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  SessionStore store(path());
  ASSERT_THAT(store.unsaved(), SizeIs(1));
  EXPECT_EQ(store.unsaved()[0].session.settings.combine.k_depth, 0.5F);
}

TEST_F(SessionStoreTest, two_windows_keep_apart) {
  SessionStore a(path());
  SessionStore b(path());
  a.load();
  b.load();
  a.autosave(session_with_k(0.1F));
  b.autosave(session_with_k(0.2F));
  {
    SessionStore third(path());
    EXPECT_THAT(third.unsaved(), IsEmpty()) << "both are alive";
    third.load();
    third.autosave(session_with_k(0.3F));
    third.close(session_with_k(0.3F));
  }
  a.close(session_with_k(0.15F));
  EXPECT_EQ(SessionStore(path()).load().settings.combine.k_depth, 0.15F);
  b.close(session_with_k(0.25F));
  EXPECT_EQ(SessionStore(path()).load().settings.combine.k_depth, 0.25F) << "the last one decides";
}

TEST_F(SessionStoreTest, unsaved_work_is_offered_to_one_window_only) {
  crash_with(0.5F);
  SessionStore a(path());
  SessionStore b(path());
  EXPECT_THAT(a.unsaved(), SizeIs(1));
  EXPECT_THAT(b.unsaved(), IsEmpty());
  b.load();
  b.autosave(session_with_k(0.9F));
  EXPECT_EQ(a.unsaved()[0].session.settings.combine.k_depth, 0.5F);
}

TEST_F(SessionStoreTest, several_crashes_are_offered_newest_first) {
  {
    SessionStore a(path());
    SessionStore b(path());
    SessionStore c(path());
    b.load();
    b.autosave(session_with_k(0.2F));
    a.autosave(session_with_k(0.1F));
    c.autosave(session_with_k(0.3F));
  }
  const auto age = [&](const char* window, int hours) {
    fs::last_write_time(path() / "windows" / window / "autosave.toml",
                        fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  age("1", 2);
  age("2", 1);
  age("3", 3);
  SessionStore store(path());
  ASSERT_THAT(store.unsaved(), SizeIs(3));
  std::vector<float> order;
  for (const UnsavedWork& work : store.unsaved()) order.push_back(work.session.settings.combine.k_depth);
  EXPECT_THAT(order, ElementsAre(0.2F, 0.1F, 0.3F));
  store.forget_unsaved(1);
  EXPECT_EQ(store.unsaved()[1].session.settings.combine.k_depth, 0.3F);
  EXPECT_FALSE(fs::exists(path() / "windows/1/autosave.toml"));
  EXPECT_TRUE(fs::exists(path() / "windows/3/autosave.toml"));
}

TEST_F(SessionStoreTest, a_damaged_session_is_put_aside_and_does_not_block) {
  for (const char* damage : {"", "[[", "[combine]\nk_depth = 99\n", "\xff\xfe", "[session]\nlayout = 3\n"}) {
    const bool is_damaged = *damage != '\0';
    folder_.write("session.toml", damage);
    SessionStore store(path());
    const Session session = store.load();
    EXPECT_THAT(store.notes(), SizeIs(is_damaged ? 1 : 0)) << damage;
    if (!is_damaged) continue;
    EXPECT_EQ(text(session.settings), text(paper_settings()));
    EXPECT_EQ(file("session.toml.bad"), damage);
    EXPECT_FALSE(fs::exists(path() / "session.toml"));
    EXPECT_THAT(store.notes()[0], AllOf(HasSubstr("session.toml:"), HasSubstr("session.toml.bad")));
  }
}

TEST_F(SessionStoreTest, a_session_of_a_newer_version_is_kept_but_for_what_is_unknown) {
  std::string content = "[fog]\nnear = 1\n" + session_text(session_with_k(0.25F));
  for (int i = 0; i < 9; ++i) content += "new_" + std::to_string(i) + " = 1\n";  // of the last light
  for (const char* name : {"session.toml", "windows/1/autosave.toml"}) folder_.write(name, content);
  SessionStore store(path());
  EXPECT_EQ(session_text(store.load()), session_text(session_with_k(0.25F)));
  ASSERT_THAT(store.unsaved(), SizeIs(1));
  EXPECT_EQ(session_text(store.unsaved()[0].session), session_text(session_with_k(0.25F)));
  ASSERT_THAT(store.notes(), SizeIs(2));
  EXPECT_THAT(store.notes()[1], AllOf(HasSubstr("session.toml: left out"), HasSubstr(": fog (line 1), "),
                                      HasSubstr("new_0"), HasSubstr(" and 2 more")));
  EXPECT_TRUE(fs::exists(path() / "session.toml"));
  EXPECT_FALSE(fs::exists(path() / "session.toml.bad"));
}

TEST_F(SessionStoreTest, windows_keep_each_others_recent_files_and_bookmarks) {
  const auto recent = [&](const char* name) { return folder_.write(name, "x"); };
  Session before = session_with_k(0.1F);
  before.recent = {recent("old")};
  before.bookmarks = {{"stays", 1, {}}, {"goes", 2, {}}};
  SessionStore(path()).close(before);
  SessionStore a(path());
  SessionStore b(path());
  Session in_a = a.load();
  Session in_b = b.load();
  add_recent(in_a, recent("of_a"));
  in_a.bookmarks = {{"stays", 1, {}}, {"of a", 3, {}}};
  add_recent(in_b, recent("of_b"));
  in_b.bookmarks.push_back({"of b", 3, {}});
  a.close(in_a);
  b.close(in_b);
  const Session after = SessionStore(path()).load();
  EXPECT_THAT(after.recent, ElementsAre(path() / "of_b", path() / "of_a", path() / "old"));
  std::vector<std::pair<std::string, int>> bookmarks;
  for (const CameraBookmark& one : after.bookmarks) bookmarks.emplace_back(one.name, one.key);
  EXPECT_THAT(bookmarks, ElementsAre(std::pair("stays", 1), std::pair("of b", 3), std::pair("of a", 0)));
}

TEST_F(SessionStoreTest, windows_that_close_at_once_keep_each_others_recent_files) {
  constexpr int kCount = 8;
  std::vector<pid_t> children;
  for (int i = 0; i < kCount; ++i) folder_.write("file_" + std::to_string(i), "x");
  for (int i = 0; i < kCount; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      SessionStore store(path());
      Session session = store.load();
      add_recent(session, path() / ("file_" + std::to_string(i)));
      usleep(200'000);  // all have loaded
      store.close(session);
      _exit(0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) waitpid(child, nullptr, 0);
  EXPECT_THAT(SessionStore(path()).load().recent, SizeIs(kCount));
}

TEST_F(SessionStoreTest, a_folder_in_the_sessions_place_does_not_block) {
  fs::create_directories(path() / "session.toml");
  SessionStore store(path());
  EXPECT_EQ(text(store.load().settings), text(paper_settings()));
  EXPECT_THAT(store.notes(), SizeIs(1));
}

TEST_F(SessionStoreTest, a_damaged_autosave_is_put_aside) {
  folder_.write("windows/1/autosave.toml", "[session");
  SessionStore store(path());
  EXPECT_THAT(store.unsaved(), IsEmpty());
  EXPECT_THAT(store.notes(), ElementsAre(HasSubstr("autosave.toml.bad")));
  EXPECT_EQ(file("windows/1/autosave.toml.bad"), "[session");
  store.load();
  EXPECT_TRUE(store.autosave(session_with_k(0.5F)));
}

TEST_F(SessionStoreTest, a_folder_that_cannot_be_written_is_a_note) {
  folder_.write("in_the_way", "");
  SessionStore store(path() / "in_the_way");
  EXPECT_THAT(store.notes(), ElementsAre(HasSubstr("unsaved work cannot be kept")));
  EXPECT_EQ(text(store.load().settings), text(paper_settings()));
  EXPECT_FALSE(store.autosave(session_with_k(0.5F)));
  error_of([&] { store.close(session_with_k(0.5F)); }, ErrorKind::work);
}

TEST_F(SessionStoreTest, a_full_disk_keeps_the_autosave_before) {
  SessionStore store(path());
  store.load();
  store.autosave(session_with_k(0.5F));
  {
    const FileSizeLimit full(64);
    error_of([&] { store.autosave(session_with_k(0.6F)); }, ErrorKind::work);
    error_of([&] { store.close(session_with_k(0.6F)); }, ErrorKind::work);
  }
  EXPECT_EQ(file("windows/1/autosave.toml"), session_text(session_with_k(0.5F)));
}

TEST_F(SessionStoreTest, a_scene_file_that_is_gone_is_a_note_and_its_settings_stay) {
  Session session = session_with_k(0.5F);
  session.scene = path() / "gone.toml";
  session.recent = {path() / "gone.toml"};
  SessionStore(path()).close(session);
  SessionStore store(path());
  const Session again = store.load();
  EXPECT_TRUE(again.scene.empty());
  EXPECT_THAT(again.recent, IsEmpty());
  EXPECT_EQ(text(again.settings), text(session.settings));
  EXPECT_THAT(store.notes(), ElementsAre(HasSubstr("gone.toml is no longer there")));
}

TEST_F(SessionStoreTest, windows_that_start_at_once_take_places_of_their_own) {
  // Processes, since that is what they are; each answers with the work that it was offered.
  crash_with(0.5F);
  std::vector<pid_t> children;
  for (int i = 0; i < 8; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      SessionStore store(path());
      store.load();
      store.autosave(session_with_k(0.01F * static_cast<float>(i + 1)));
      usleep(300'000);  // all are alive together
      _exit(static_cast<int>(store.unsaved().size()));
    }
    children.push_back(child);
  }
  int offered = 0;
  for (const pid_t child : children) {
    int status = 0;
    waitpid(child, &status, 0);
    offered += WEXITSTATUS(status);
  }
  EXPECT_EQ(offered, 1);
  std::set<float> found;
  const SessionStore store(path());
  for (const UnsavedWork& work : store.unsaved()) found.insert(work.session.settings.combine.k_depth);
  EXPECT_THAT(found, SizeIs(9)) << "the first crash and the eight of now";
}

}  // namespace
}  // namespace inkbench
