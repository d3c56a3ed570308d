// SPDX-License-Identifier: MIT
#include "app/workbench/session_store.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "app/workbench/session_merge.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

constexpr int kMaxWindows = 100;
constexpr size_t kMaxNamed = 8;
constexpr int kLockTries = 100;
constexpr auto kLockPause = std::chrono::milliseconds(20);

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

}  // namespace

SessionStore::SessionStore(fs::path folder) : folder_(std::move(folder)) {
  take_places();
  std::sort(unsaved_.begin(), unsaved_.end(),
            [](const UnsavedWork& a, const UnsavedWork& b) { return a.time > b.time; });
}

SessionStore::~SessionStore() = default;

void SessionStore::take_places() {
  std::string trouble;
  for (int i = 1; i <= kMaxWindows; ++i) {
    Place place{folder_ / "windows" / std::to_string(i), nullptr};
    std::error_code error;
    const bool is_there = fs::is_directory(place.folder, error);
    if (own_.lock != nullptr && !is_there) continue;
    try {
      place.lock = std::make_unique<FolderLock>(place.folder);
    } catch (const Error& cause) {
      trouble = cause.what();                               // held by a living window, or not to be written
      if (fs::is_directory(place.folder, error)) continue;  // by now, where another window was faster
      break;
    }
    if (is_file(place.file())) {
      read_unsaved(std::move(place));
    } else if (own_.lock == nullptr) {
      own_ = std::move(place);
    }
  }
  if (own_.lock == nullptr) notes_.push_back("unsaved work cannot be kept for the next start: " + trouble);
}

void SessionStore::read_unsaved(Place place) {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(place.file(), error);
  try {
    Session session = read(place.file());
    unsaved_.push_back({std::move(session), place.file(), time, std::move(place.lock)});
  } catch (const Error& cause) {
    put_aside(place.file(), cause.what());
    if (own_.lock == nullptr && !is_file(place.file())) own_ = std::move(place);
  }
}

void SessionStore::put_aside(const fs::path& file, const std::string& reason) {
  fs::path aside = file;
  aside += ".bad";
  std::error_code error;
  fs::rename(file, aside, error);
  notes_.push_back(error ? reason : reason + "; the file is now " + aside.string());
}

Session SessionStore::read(const fs::path& file) {
  std::vector<std::string> left_out;
  Session session = parse_session(read_file(file), file.string(), &left_out);
  if (left_out.empty()) return session;
  const size_t more = left_out.size() - std::min(left_out.size(), kMaxNamed);
  left_out.resize(left_out.size() - more);
  notes_.push_back(file.string() + ": left out what this version does not know: " + join(left_out, ", ") +
                   (more > 0 ? " and " + std::to_string(more) + " more" : ""));
  return session;
}

Session SessionStore::load() {
  const fs::path file = folder_ / "session.toml";
  Session session;
  bool is_read = false;
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error))) {
    try {
      session = read(file);
      is_read = true;
    } catch (const Error& cause) {
      put_aside(file, "the last session cannot be read: " + std::string(cause.what()));
    }
  }
  if (!is_read) session = first_session();
  drop_missing_recent(session);
  if (!session.scene.empty() && !is_file(session.scene)) {
    notes_.push_back("the scene file " + session.scene.string() +
                     " is no longer there; its settings were kept");
    session.scene.clear();
  }
  last_text_ = session_text(session);
  started_ = session;
  return session;
}

void SessionStore::forget_unsaved(size_t index) {
  std::error_code error;
  fs::remove(unsaved_.at(index).file, error);
  unsaved_.erase(unsaved_.begin() + static_cast<std::ptrdiff_t>(index));
}

bool SessionStore::autosave(const Session& session) {
  std::string text = session_text(session);
  if (own_.lock == nullptr || text == last_text_) return false;
  write_file_atomically(own_.file(), text);
  last_text_ = std::move(text);
  return true;
}

/// Against another window that closes at the same time. None where it cannot be had soon: the session counts
/// more than the other's lists.
std::unique_ptr<FolderLock> SessionStore::lock_session() const {
  std::error_code error;
  for (int i = 0; i < kLockTries && fs::is_directory(folder_, error); ++i) {
    try {
      return std::make_unique<FolderLock>(folder_);
    } catch (const Error&) {
      std::this_thread::sleep_for(kLockPause);
    }
  }
  return nullptr;
}

Session SessionStore::merged(Session session) const {
  const fs::path file = folder_ / "session.toml";
  if (!is_file(file)) return session;
  try {
    Session theirs = parse_session(read_file(file), file.string());
    drop_missing_recent(theirs);
    merge_lists(started_, theirs, session);
  } catch (const Error&) {
    // What cannot be read has nothing to keep.
  }
  return session;
}

void SessionStore::close(const Session& session) {
  const std::unique_ptr<FolderLock> lock = lock_session();
  write_file_atomically(folder_ / "session.toml", session_text(merged(session)));
  std::error_code error;
  if (own_.lock != nullptr) fs::remove(own_.file(), error);
  remove_abandoned_files(folder_);
}

}  // namespace inkbench
