// SPDX-License-Identifier: MIT
#include "app/workbench/session.h"

#include <algorithm>

#include "app/workbench/scene_base.h"
#include "app/workbench/unknown_entries.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/levels/scene_file.h"
#include "pipeline/params/toml_reader.h"
#include "pipeline/params/toml_value.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

std::string struct_text(const Description& description, const void* owner) {
  std::string text;
  for (const Field& field : description.fields)
    text += std::string(field.name) + " = " + to_text(field.get(owner)) + "\n";
  return text;
}

/// A path that TOML cannot hold is left out: it would make the file unreadable.
std::string path_entry(const fs::path& path) {
  return to_text(Value(is_utf8(path.string()) ? path.string() : std::string()));
}

/// Reads the [session] table of one document; `left_out` takes what it does not know.
class SessionReader {
 public:
  SessionReader(const std::string& name, std::vector<std::string>& left_out)
      : name_(name), toml_(name), left_out_(left_out) {}

  void read(const TomlNode& table, Session& session) const {
    for (const auto& [key, node] : toml_.entries_of(table, "session")) {
      if (key == "scene") {
        session.scene = toml_.text_of(node, key);
      } else if (key == "recent") {
        for (const TomlNode& item : toml_.items_of(node, key))
          session.recent.emplace_back(toml_.text_of(item, key));
      } else if (key == "layout") {
        read_struct(WindowLayout::description(), &session.layout, node, "session.layout");
      } else if (key == "bookmark") {
        for (const TomlNode& item : toml_.items_of(node, key)) session.bookmarks.push_back(bookmark(item));
      } else if (key == "marks") {
        for (const TomlNode& item : toml_.items_of(node, key))
          session.marks.push_back(read_camera_marks(item, name_, left_out_));
      } else {
        left_out_.push_back(left_out_name("session." + key, node));
      }
    }
  }

 private:
  void read_struct(const Description& description, void* owner, const TomlNode& table,
                   const std::string& key) const {
    for (const auto& [name, node] : toml_.entries_of(table, key))
      set_field(description, owner, name, node, key);
  }

  void set_field(const Description& description, void* owner, const std::string& name, const TomlNode& node,
                 const std::string& key) const {
    for (const Field& field : description.fields) {
      if (field.name != name) continue;
      const Param param{key + "." + name, &field, owner};
      param.set(value_from_toml(param, node, toml_.at(node), "/"), toml_.at(node));
      return;
    }
    left_out_.push_back(left_out_name(key + "." + name, node));
  }

  CameraBookmark bookmark(const TomlNode& table) const {
    CameraBookmark result;
    for (const auto& [name, node] : toml_.entries_of(table, "session.bookmark")) {
      if (name == "name") {
        result.name = toml_.text_of(node, name);
      } else if (name == "key") {
        set_field(CameraBookmark::description(), &result, name, node, "session.bookmark");
      } else {
        set_field(CameraParams::description(), &result.camera, name, node, "session.bookmark");
      }
    }
    return result;
  }

  std::string name_;
  TomlReader toml_;
  std::vector<std::string>& left_out_;
};

}  // namespace

const Description& CameraBookmark::description() {
  static const Description kDescription{
      "bookmark",
      "A bookmark of a camera",
      {field<&CameraBookmark::key>(
          {.name = "key", .help = "The digit that recalls it; 0: none.", .limits = {0, 9}})}};
  return kDescription;
}

Session first_session() {
  Session session;
  session.scene = default_scene();
  session.settings = load_scene_file(session.scene);
  return session;
}

void add_recent(Session& session, const fs::path& file) {
  const fs::path path = fs::absolute(file).lexically_normal();
  std::erase(session.recent, path);
  session.recent.insert(session.recent.begin(), path);
  if (session.recent.size() > kMaxRecent) session.recent.resize(kMaxRecent);
}

void drop_missing_recent(Session& session) {
  std::erase_if(session.recent, [](const fs::path& path) {
    std::error_code error;
    return !fs::is_regular_file(path, error);
  });
}

std::string session_text(const Session& session) {
  std::vector<std::string> recent;
  for (const fs::path& path : session.recent) {
    if (is_utf8(path.string())) recent.push_back(path_entry(path));
  }
  std::string text = "# inkbench session\n[session]\nscene = " + path_entry(session.scene) + "\nrecent = [" +
                     join(recent, ", ") + "]\n[session.layout]\n" +
                     struct_text(WindowLayout::description(), &session.layout);
  for (const CameraBookmark& bookmark : session.bookmarks) {
    text += "[[session.bookmark]]\nname = " + to_text(Value(bookmark.name)) + "\n" +
            struct_text(CameraBookmark::description(), &bookmark) +
            struct_text(CameraParams::description(), &bookmark.camera);
  }
  return text + marks_text(session.marks, "session.marks") + settings_text(session.settings);
}

Session parse_session(std::string_view text, const std::string& name, std::vector<std::string>* left_out) {
  TomlNode document = parse_toml(text, name);
  Session session;
  std::vector<std::string> unknown;
  if (const TomlNode* table = document.find("session")) SessionReader(name, unknown).read(*table, session);
  std::erase_if(document.entries, [](const TomlEntry& entry) { return entry.key == "session"; });
  const std::vector<std::string> parameters = take_unknown_entries(document);
  unknown.insert(unknown.end(), parameters.begin(), parameters.end());
  if (left_out != nullptr) *left_out = std::move(unknown);
  session.settings = parse_settings(document, name, "/");
  session.recent.resize(std::min(session.recent.size(), kMaxRecent));
  session.bookmarks.resize(std::min(session.bookmarks.size(), kMaxBookmarks));
  return session;
}

}  // namespace inkbench
