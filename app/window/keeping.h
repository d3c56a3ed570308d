// SPDX-License-Identifier: MIT
// What outlives the window: the last session, unsaved work of one that died, presets, recent files, camera
// bookmarks. In: the user's folder; the rest of a session is document and layout.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/workbench/document.h"
#include "app/workbench/presets.h"
#include "app/workbench/session_store.h"

namespace inkbench {

class Keeping {
 public:
  /// Throws nothing: where nothing can be kept, a note says why.
  Keeping();

  /// The last session, or the first one. Errors: as `first_session`.
  Session start();

  /// Now and then, also while nothing happens: writes the autosave if something changed and the last one is
  /// some seconds old.
  void autosave(const Document& document, const WindowLayout& layout, double now_seconds);
  /// A clean exit.
  void close(const Document& document, const WindowLayout& layout);

  /// What windows that died had not saved, newest first.
  std::span<const UnsavedWork> unsaved() const;
  /// Takes the newest unsaved work over; undo brings back what was there.
  void restore(Document& document, WindowLayout& layout);
  /// Removes the newest unsaved work for good.
  void discard();

  /// What a person should hear of, once: what could not be read or written.
  std::vector<std::string> take_notes();

  const PresetStore& presets() const { return presets_; }

  const std::vector<std::filesystem::path>& recent() const { return kept_.recent; }
  void add_recent(const std::filesystem::path& file);

  const std::vector<CameraBookmark>& bookmarks() const { return kept_.bookmarks; }
  /// Changes the bookmarks through here, so that they are saved. Drops what is too much.
  void set_bookmarks(std::vector<CameraBookmark> bookmarks);

 private:
  Session session_of(const Document& document, const WindowLayout& layout) const;
  void drop_known_work(Session& session);
  void save_now(const Document& document, const WindowLayout& layout);

  std::filesystem::path folder_;
  std::vector<std::string> notes_;
  std::unique_ptr<SessionStore> store_;  ///< None where there is no folder.
  PresetStore presets_;
  Session kept_;  ///< Its recent files and bookmarks.
  long own_revision_ = 0, saved_revision_ = -1;
  WindowLayout saved_layout_;
  double next_save_ = 0.0;
};

}  // namespace inkbench
