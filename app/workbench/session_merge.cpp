// SPDX-License-Identifier: MIT
#include "app/workbench/session_merge.h"

#include <algorithm>

namespace inkbench {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<fs::path>;
using Bookmarks = std::vector<CameraBookmark>;

template <class List, class Item>
bool holds(const List& list, const Item& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

bool same_view(const CameraBookmark& a, const CameraBookmark& b) {
  return a.name == b.name && same_camera(a.camera, b.camera);
}

bool holds_bookmark(const Bookmarks& list, const CameraBookmark& wanted) {
  return std::any_of(list.begin(), list.end(), [&](const CameraBookmark& one) {
    return one.key == wanted.key && same_view(one, wanted);
  });
}

bool holds_view(const Bookmarks& list, const CameraBookmark& wanted) {
  return std::any_of(list.begin(), list.end(),
                     [&](const CameraBookmark& one) { return same_view(one, wanted); });
}

bool holds_key(const Bookmarks& list, int key) {
  return std::any_of(list.begin(), list.end(), [&](const CameraBookmark& one) { return one.key == key; });
}

/// New ones first, so that a full list does not push them out.
Files merged_files(const Files& base, const Files& theirs, const Files& ours) {
  Files merged;
  const auto add = [&](const fs::path& file) {
    if (!holds(merged, file)) merged.push_back(file);
  };
  for (const Files* list : {&ours, &theirs}) {
    for (const fs::path& file : *list) {
      if (!holds(base, file)) add(file);
    }
  }
  for (const fs::path& file : ours) add(file);
  merged.resize(std::min(merged.size(), kMaxRecent));
  return merged;
}

Bookmarks merged_bookmarks(const Bookmarks& base, const Bookmarks& theirs, Bookmarks ours) {
  std::erase_if(ours, [&](const CameraBookmark& one) {
    return holds_bookmark(base, one) && !holds_bookmark(theirs, one);
  });
  for (CameraBookmark one : theirs) {
    if (holds_bookmark(base, one) || holds_view(ours, one)) continue;
    if (holds_key(ours, one.key)) one.key = 0;
    ours.push_back(std::move(one));
  }
  ours.resize(std::min(ours.size(), kMaxBookmarks));
  return ours;
}

}  // namespace

void merge_lists(const Session& base, const Session& theirs, Session& ours) {
  ours.recent = merged_files(base.recent, theirs.recent, ours.recent);
  ours.bookmarks = merged_bookmarks(base.bookmarks, theirs.bookmarks, std::move(ours.bookmarks));
}

}  // namespace inkbench
