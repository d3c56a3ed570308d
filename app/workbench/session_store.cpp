#include "app/workbench/session_store.h"

#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"

namespace inkbench {
namespace {

constexpr int kMaxWindows = 100;

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
    Session session = parse_session(read_file(place.file()), place.file().string());
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

Session SessionStore::load() {
  const fs::path file = folder_ / "session.toml";
  Session session;
  bool is_read = false;
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error))) {
    try {
      session = parse_session(read_file(file), file.string());
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

void SessionStore::close(const Session& session) {
  write_file_atomically(folder_ / "session.toml", session_text(session));
  std::error_code error;
  if (own_.lock != nullptr) fs::remove(own_.file(), error);
  remove_abandoned_files(folder_);
}

}  // namespace inkbench
