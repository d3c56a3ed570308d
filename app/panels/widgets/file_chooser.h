// SPDX-License-Identifier: MIT
// Choosing a file inside the window: places on the left, a folder's files, a path to type. In: what is asked
// for. Out: the path, once it is chosen.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/window/keeping.h"
#include "app/window/ui_map.h"
#include "app/workbench/folder_listing.h"

namespace inkbench {

struct ChooserQuestion {
  std::string title, help, button;
  std::vector<std::string_view>
      extensions;                ///< Of the files to list; a saved name without one gets the first.
  std::filesystem::path folder;  ///< Where to start; empty: the recent files.
  bool saves = false;            ///< A name is asked for that need not be there yet.
  std::string name;              ///< The one to begin with.
};

class FileChooser {
 public:
  /// Both must outlive it.
  FileChooser(const Keeping& keeping, UiMap& ui_map) : keeping_(keeping), ui_map_(ui_map) {}

  void ask(ChooserQuestion question);
  bool is_open() const { return asking_ || open_; }

  /// Once a frame. `extras` draws more between list and buttons. Returns the path in the frame in which it is
  /// chosen; when saving over a file, the person has agreed to it.
  std::optional<std::filesystem::path> draw(const std::function<void()>& extras = {});

  /// The name typed so far, when saving.
  std::string& name() { return question_.name; }
  const std::filesystem::path& folder() const { return listing_.folder; }

 private:
  void go_to(const std::filesystem::path& folder);
  void draw_places();
  void place(const char* name, const std::filesystem::path& folder);
  void draw_path();
  void draw_entries(float height);
  void draw_entry(size_t index);
  void move_by_keys();
  void draw_buttons();
  std::filesystem::path target() const;
  void name_file(const std::filesystem::path& path);
  void activate(const std::filesystem::path& path);
  void tell_missing(const std::filesystem::path& path);
  void open_chosen();
  void choose(const std::filesystem::path& path);
  std::filesystem::path path_of(const FolderEntry& entry) const;

  const Keeping& keeping_;
  UiMap& ui_map_;
  ChooserQuestion question_;
  bool asking_ = false, open_ = false, focus_ = false, shows_recent_ = false, scroll_ = false;
  FolderListing listing_;
  std::optional<size_t> selected_;
  std::string path_text_, problem_;
  std::optional<std::filesystem::path> replaces_;  ///< Asked whether to write over it.
  std::optional<std::filesystem::path> chosen_;
};

}  // namespace inkbench
