// SPDX-License-Identifier: MIT
#include "studies/sweep/spec_base.h"

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/mesh/levels/scene_file.h"
#include "pipeline/params/toml_reader.h"
#include "pipeline/params/toml_value.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

class BaseReader {
 public:
  BaseReader(const TomlNode& document, const fs::path& path)
      : path_(path), toml_(path.string()), document_(document) {}

  Settings read(const std::vector<std::string>& assignments) {
    base_ = load_scene_file(scene_path());
    read_size();
    read_set();
    for (const std::string& assignment : assignments) apply_assignment(base_, assignment);
    return std::move(base_);
  }

 private:
  fs::path scene_path() const {
    const TomlNode* node = document_.find("scene");
    if (node == nullptr) return project_file("data/scenes/paper.toml");
    const std::string scene = toml_.text_of(*node, "scene");
    for (const fs::path& candidate : {path_.parent_path() / scene, project_root() / scene}) {
      std::error_code error;
      if (fs::is_regular_file(candidate, error)) return candidate;
    }
    throw input_error(toml_.at(*node), "scene \"" + scene + "\" was not found",
                      "give a path relative to this file or to " + project_root().string());
  }

  void read_size() {
    const TomlNode* node = document_.find("size");
    if (node == nullptr) return;
    const bool pair = node->is_array() && node->items.size() == 2;
    if (!pair)
      throw input_error(toml_.at(*node), "size is " + node->kind_name(), "it must be [width, height] in px");
    set_value("image.width", node->items[0], toml_.at(*node));
    set_value("image.height", node->items[1], toml_.at(*node));
  }

  void set_value(const std::string& key, const TomlNode& node, const std::string& where) {
    const Param param = find_param(base_, key, where);
    param.set(value_from_toml(param, node, where, path_.parent_path().string()), where);
  }

  void read_set() {
    const TomlNode* set = document_.find("set");
    if (set == nullptr) return;
    if (!set->is_table())
      throw input_error(toml_.at(*set), "set is " + set->kind_name(), "it must be a table: [set]");
    apply_table(base_, *set, path_.string(), path_.parent_path());
  }

  const fs::path& path_;
  TomlReader toml_;
  const TomlNode& document_;
  Settings base_;
};

}  // namespace

Settings read_base(const TomlNode& document, const fs::path& path,
                   const std::vector<std::string>& assignments) {
  return BaseReader(document, path).read(assignments);
}

}  // namespace inkbench
