// SPDX-License-Identifier: MIT
#include "app/workbench/unknown_entries.h"

#include <algorithm>

#include "pipeline/settings/settings.h"

namespace inkbench {
namespace {

class Sieve {
 public:
  std::vector<std::string> sift(TomlNode& document) {
    std::vector<TomlEntry> known;
    for (TomlEntry& entry : document.entries) {
      const bool is_named = entry.key == "model" || entry.key == "light";
      if (is_named) sift_list(entry.key, entry.node);
      const bool stays = is_named || entry.key == "title" || entry.key == "base";
      if (stays || is_known(entry.key, entry.node)) known.push_back(std::move(entry));
    }
    document.entries = std::move(known);
    return std::move(taken_);
  }

 private:
  void sift_list(const std::string& list, TomlNode& array) {
    for (TomlNode& item : array.items) {
      const TomlNode* name = item.find("name");
      if (name == nullptr || !name->is_text()) continue;
      settings_.models.assign(1, {});
      settings_.lights.assign(1, {});
      settings_.models[0].name = settings_.lights[0].name = name->text;
      name_key_ = list + "." + name->text + ".name";
      sift_table(list + "." + name->text, item);
    }
  }

  void sift_table(const std::string& prefix, TomlNode& table) {
    std::vector<TomlEntry> known;
    for (TomlEntry& entry : table.entries) {
      const std::string key = prefix + "." + entry.key;
      if (key == name_key_ || is_known(key, entry.node)) known.push_back(std::move(entry));
    }
    table.entries = std::move(known);
  }

  /// Also sifts what is below it.
  bool is_known(const std::string& key, TomlNode& node) {
    if (!is_group(key) && !has_param(settings_, key)) {
      taken_.push_back(left_out_name(key, node));
      return false;
    }
    const bool had_entries = !node.entries.empty();
    if (node.is_table()) sift_table(key, node);
    return !had_entries || !node.entries.empty();
  }

  bool is_group(const std::string& key) {
    const std::vector<ParamGroup> groups = list_groups(settings_);
    return std::any_of(groups.begin(), groups.end(),
                       [&](const ParamGroup& group) { return group.prefix == key; });
  }

  Settings settings_;  ///< With the model or light that is looked at.
  std::string name_key_;
  std::vector<std::string> taken_;
};

}  // namespace

std::string left_out_name(const std::string& key, const TomlNode& node) {
  return key + " (line " + std::to_string(node.line) + ")";
}

std::vector<std::string> take_unknown_entries(TomlNode& document) {
  return Sieve().sift(document);
}

}  // namespace inkbench
