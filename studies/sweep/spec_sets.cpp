// SPDX-License-Identifier: MIT
#include "studies/sweep/spec_sets.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/params/toml_reader.h"
#include "pipeline/params/toml_value.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

/// It becomes part of file names.
void check_part_name(const std::string& kind, const std::string& name, const std::string& where) {
  const bool good = !name.empty() && name.size() <= 40 && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  if (good) return;
  throw input_error(where, "a " + kind + " is named \"" + name + "\"",
                    "its files bear its name: use 1 to 40 of a-z, 0-9, - and _");
}

class SetsReader {
 public:
  explicit SetsReader(const StudySpec& spec) : spec_(spec), toml_(spec.path.string()), base_(spec.base) {}

  std::vector<NamedSet> variants(const TomlNode& document) {
    const std::vector<const TomlNode*> tables = tables_of(document, "variant");
    const std::vector<NamedSet> sets = named_sets("variant", tables);
    if (!sets.empty() && spec_.axes.size() > 2)
      throw input_error(toml_.at(*tables.front()), "three [[axis]] and [[variant]]",
                        "columns, rows and pages are all taken: at most two axes beside variants");
    for (size_t i = 0; i < sets.size(); ++i) {
      for (const Assignment& assignment : sets[i].set)
        check_not_an_axis(assignment.key, "variant", toml_.at(*tables[i]));
    }
    return sets;
  }

  std::vector<NamedSet> sets(const TomlNode& document, const std::string& kind) {
    const std::vector<const TomlNode*> tables = tables_of(document, kind);
    const std::vector<NamedSet> sets = named_sets(kind, tables);
    for (size_t i = 0; i < sets.size(); ++i) check_part_name(kind, sets[i].name, toml_.at(*tables[i]));
    return sets;
  }

  std::vector<NamedSet> views(const TomlNode& document) {
    const std::vector<const TomlNode*> tables = tables_of(document, "view");
    if (spec_.camera_path && !tables.empty())
      throw input_error(toml_.at(*tables.front()), "a [[view]] beside a [path]",
                        "leave one of them out: the frames of the path are the views");
    if (spec_.camera_path) return frames(*spec_.camera_path);
    const std::vector<NamedSet> sets = named_sets("view", tables);
    for (size_t i = 0; i < sets.size(); ++i) {
      const std::string where = toml_.at(*tables[i]);
      check_part_name("view", sets[i].name, where);
      for (const Assignment& assignment : sets[i].set) check_not_varied(assignment.key, where);
    }
    return sets;
  }

 private:
  /// Named so that they sort, and that programs that read numbered pictures find them.
  static std::vector<NamedSet> frames(const CameraPath& path) {
    const size_t digits = std::max<size_t>(3, std::to_string(path.frames - 1).size());
    std::vector<NamedSet> sets;
    for (int i = 0; i < path.frames; ++i) sets.push_back({fmt::format("frame_{:0{}}", i, digits), {}});
    return sets;
  }

  std::vector<const TomlNode*> tables_of(const TomlNode& document, const std::string& kind) const {
    const std::vector<const TomlNode*> tables = toml_.tables(document, kind);
    const TomlNode* list = document.find(kind);
    if (list != nullptr && tables.empty())
      throw input_error(toml_.at(*list), "an empty list of " + kind + "s");
    return tables;
  }

  std::vector<NamedSet> named_sets(const std::string& kind, const std::vector<const TomlNode*>& tables) {
    std::vector<NamedSet> sets;
    for (const TomlNode* table : tables) {
      toml_.check_keys(*table, {"name", "set"});
      const TomlNode* name = table->find("name");
      if (name == nullptr)
        throw input_error(toml_.at(*table), "a [[" + kind + "]] without a name",
                          "give it one: name = \"front\"");
      NamedSet set{toml_.text_of(*name, "name"), {}};
      for (const NamedSet& other : sets) {
        if (other.name == set.name)
          throw input_error(toml_.at(*name), "a second " + kind + " is named \"" + set.name + "\"",
                            "names must differ");
      }
      if (const TomlNode* values = table->find("set")) set.set = assignments_in(*values, kind);
      sets.push_back(std::move(set));
    }
    return sets;
  }

  /// The leaves of a variant's or view's set as assignments, checked.
  std::vector<Assignment> assignments_in(const TomlNode& table, const std::string& kind) {
    if (!table.is_table())
      throw input_error(toml_.at(table), "set is " + table.kind_name(),
                        "it must be a table: [" + kind + ".set]");
    std::vector<Assignment> result;
    visit_table(base_, table, "", spec_.path.string(), [&](const Param& param, const TomlNode& node) {
      const std::string where = toml_.at(node);
      const Value value = value_from_toml(param, node, where, spec_.path.parent_path().string());
      check_value(*param.field, param.key, value, where);
      result.push_back({param.key, value});
    });
    return result;
  }

  void check_not_varied(const std::string& key, const std::string& where) {
    check_not_an_axis(key, "view", where);
    for (const NamedSet& variant : spec_.variants) {
      for (const Assignment& assignment : variant.set) {
        if (overlap(key, assignment.key))
          throw input_error(where, "a view sets " + key + ", and so does variant \"" + variant.name + "\"",
                            "let one of them set it");
      }
    }
  }

  void check_not_an_axis(const std::string& key, const std::string& kind, const std::string& where) {
    for (const Axis& axis : spec_.axes) {
      if (overlap(key, axis.key))
        throw input_error(where, "a " + kind + " sets " + key + ", which an axis varies",
                          "let one of them set it");
    }
  }

  bool overlap(const std::string& key, const std::string& other) {
    return find_param(base_, key, key).overlaps(find_param(base_, other, other));
  }

  const StudySpec& spec_;
  TomlReader toml_;
  Settings base_;
};

}  // namespace

std::vector<NamedSet> read_variants(const TomlNode& document, const StudySpec& spec) {
  return SetsReader(spec).variants(document);
}

std::vector<NamedSet> read_sets(const TomlNode& document, const std::string& kind, const StudySpec& spec) {
  return SetsReader(spec).sets(document, kind);
}

std::vector<NamedSet> read_views(const TomlNode& document, const StudySpec& spec) {
  return SetsReader(spec).views(document);
}

}  // namespace inkbench
