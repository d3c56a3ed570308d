// SPDX-License-Identifier: MIT
// Lists that two windows changed: nothing that either added is lost.
#include "app/workbench/session_merge.h"

#include <gmock/gmock.h>

namespace inkbench {
namespace {

namespace fs = std::filesystem;

using ::testing::ElementsAre;
using ::testing::SizeIs;

Session with_files(std::vector<fs::path> files) {
  Session session;
  session.recent = std::move(files);
  return session;
}

Session with_bookmarks(std::vector<CameraBookmark> bookmarks) {
  Session session;
  session.bookmarks = std::move(bookmarks);
  return session;
}

std::vector<std::string> names(const Session& session) {
  std::vector<std::string> result;
  for (const CameraBookmark& one : session.bookmarks)
    result.push_back(one.name + " " + std::to_string(one.key));
  return result;
}

TEST(SessionMerge, new_files_of_both_come_before_old_ones) {
  Session ours = with_files({"/mine", "/b", "/a"});
  merge_lists(with_files({"/a", "/b"}), with_files({"/theirs", "/mine", "/a", "/b"}), ours);
  EXPECT_THAT(ours.recent, ElementsAre("/mine", "/theirs", "/b", "/a"));
}

TEST(SessionMerge, a_full_list_keeps_the_new_files_of_both) {
  std::vector<fs::path> old;
  for (size_t i = 0; i < kMaxRecent; ++i) old.emplace_back("/" + std::to_string(i));
  Session base = with_files(old);
  Session theirs = base;
  Session ours = base;
  add_recent(theirs, "/theirs");
  add_recent(ours, "/ours");
  merge_lists(base, theirs, ours);
  ASSERT_THAT(ours.recent, SizeIs(kMaxRecent));
  EXPECT_EQ(ours.recent[0], "/ours");
  EXPECT_EQ(ours.recent[1], "/theirs");
}

TEST(SessionMerge, bookmarks_of_both_are_kept_and_removed_ones_go) {
  Session ours = with_bookmarks({{"a", 1, {}}, {"b", 2, {}}, {"ours", 3, {}}});
  merge_lists(with_bookmarks({{"a", 1, {}}, {"b", 2, {}}, {"c", 4, {}}}),
              with_bookmarks({{"a", 1, {}}, {"theirs", 3, {}}, {"c", 4, {}}}), ours);
  EXPECT_THAT(names(ours), ElementsAre("a 1", "ours 3", "theirs 0"));
}

TEST(SessionMerge, a_bookmark_that_the_other_changed_is_changed) {
  const Session base = with_bookmarks({{"a", 1, {}}, {"b", 2, {}}});
  Session ours = base;
  merge_lists(base, with_bookmarks({{"a", 7, {}}, {"b", 2, {.fov = 60}}}), ours);
  EXPECT_THAT(names(ours), ElementsAre("a 7", "b 2"));
  EXPECT_EQ(ours.bookmarks[1].camera.fov, 60.0F);
}

TEST(SessionMerge, the_same_bookmark_of_both_is_there_once) {
  Session ours = with_bookmarks({{"a", 1, {}}});
  merge_lists({}, with_bookmarks({{"a", 5, {}}}), ours);
  EXPECT_THAT(names(ours), ElementsAre("a 1"));
}

TEST(SessionMerge, too_many_bookmarks_keep_ours) {
  Session ours = with_bookmarks(std::vector<CameraBookmark>(kMaxBookmarks, {"ours", 0, {}}));
  merge_lists({}, with_bookmarks({{"theirs", 0, {}}}), ours);
  ASSERT_THAT(ours.bookmarks, SizeIs(kMaxBookmarks));
  EXPECT_EQ(ours.bookmarks.back().name, "ours");
}

}  // namespace
}  // namespace inkbench
