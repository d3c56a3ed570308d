// SPDX-License-Identifier: MIT
// What comes back at the next start: settings, scene, window, recent files, camera bookmarks, marks. Here as
// a value and as text; session_store.h keeps it on the disk.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/workbench/painted_marks.h"
#include "app/workbench/window_layout.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

struct CameraBookmark {
  std::string name;  ///< Any text; names may repeat.
  int key = 0;       ///< The digit that recalls it; 0: none.
  CameraParams camera;

  static const Description& description();  ///< Of `key`.
};

struct Session {
  Settings settings;
  std::filesystem::path scene;  ///< The file that the settings started from; empty without one.
  WindowLayout layout;
  std::vector<std::filesystem::path> recent;  ///< Newest first, each once, at most `kMaxRecent`.
  std::vector<CameraBookmark> bookmarks;      ///< At most `kMaxBookmarks`.
  PaintedMarks marks;                         ///< Over the pictures of these settings.
};

inline constexpr size_t kMaxRecent = 12, kMaxBookmarks = 100;

/// The paper's scene, as at a first start. Errors: as `load_settings`.
Session first_session();

/// Puts the file, made absolute, at the front of the list and drops what is too much.
void add_recent(Session& session, const std::filesystem::path& file);

/// Drops recent files that are no longer there.
void drop_missing_recent(Session& session);

/// A TOML document: a table [session], then all settings as in a scene file. Reading it back gives an equal
/// session.
std::string session_text(const Session& session);

/// Entries that this version does not know are left out and, where there is a list for it, named in
/// `left_out`. Errors (input): `name:line` of what is broken or out of range.
Session parse_session(std::string_view text, const std::string& name,
                      std::vector<std::string>* left_out = nullptr);

}  // namespace inkbench
