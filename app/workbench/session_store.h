// SPDX-License-Identifier: MIT
// The session on the disk. Each window autosaves into a folder of its own, which it holds locked for as long
// as it lives: two windows cannot overwrite each other's work, and since the system lifts the lock of a
// window that died, however it died, an autosave that nobody holds is unsaved work. A clean exit writes
// session.toml and removes the autosave; the window closed last decides what session.toml says, but for
// recent files and bookmarks, which all windows share.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/workbench/session.h"
#include "studies/sweep/study_folder.h"

namespace inkbench {

/// What a window that died had not saved.
struct UnsavedWork {
  Session session;
  std::filesystem::path file;
  std::filesystem::file_time_type time;  ///< Of the last autosave.
  std::unique_ptr<FolderLock> lock;      ///< So that no other window offers it too.
};

class SessionStore {
 public:
  /// `folder`: `user_folder()` as a rule. Takes a place for the autosave and all that dead windows left.
  /// Throws nothing: what cannot be had is a note.
  explicit SessionStore(std::filesystem::path folder);
  ~SessionStore();  ///< Without `close`, leaves the autosave as unsaved work.

  /// The last session; the paper's scene at a first start, or where session.toml is damaged, which is then
  /// put aside as session.toml.bad. Errors: only those of `first_session`.
  Session load();

  /// Newest first. Stays on the disk, and is offered again at a later start, until it is forgotten.
  const std::vector<UnsavedWork>& unsaved() const { return unsaved_; }
  /// Removes it for good: it was restored, or is not wanted.
  void forget_unsaved(size_t index);

  /// Writes the autosave, unless nothing has changed since the last one or the start. Returns whether it
  /// wrote. Errors (work): full disk; the autosave before stays.
  bool autosave(const Session& session);

  /// A clean exit; recent files and bookmarks that other windows wrote since `load` are kept. Errors (work):
  /// session.toml cannot be written; then the autosave stays.
  void close(const Session& session);

  /// What a person should hear of: damaged files, no place to write. In order of occurrence.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct Place {
    std::filesystem::path folder;
    std::unique_ptr<FolderLock> lock;

    std::filesystem::path file() const { return folder / "autosave.toml"; }
  };

  void take_places();
  void read_unsaved(Place place);
  Session read(const std::filesystem::path& file);
  std::unique_ptr<FolderLock> lock_session() const;
  Session merged(Session session) const;
  void put_aside(const std::filesystem::path& file, const std::string& reason);

  std::filesystem::path folder_;
  Place own_;
  std::vector<UnsavedWork> unsaved_;
  Session started_;  ///< Its lists, as `load` gave them.
  std::string last_text_;
  std::vector<std::string> notes_;
};

}  // namespace inkbench
