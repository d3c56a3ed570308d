// Specs as they are read: TOML in, a StudySpec whose every entry was looked at out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/params/toml_value.h"
#include "pipeline/scene/settings_file.h"
#include "studies/sweep/chart_spec.h"
#include "studies/sweep/number_columns.h"
#include "studies/sweep/spec.h"

namespace inkbench {
namespace {

constexpr size_t kMaxCells = 10'000'000;
constexpr int kMaxAxisCount = 1'000'000;

/// Reading one spec: the document, its name for errors and the folder that relative paths start from.
class SpecReader {
 public:
  SpecReader(const std::string& text, const fs::path& path)
      : path_(path), document_(parse_toml(text, path.string())) {
    spec_.path = path;
    spec_.text = text;
  }

  StudySpec read(const std::vector<std::string>& assignments) {
    check_keys(document_, {"title", "purpose", "scene", "size", "show", "grid_px", "measure", "set", "axis",
                           "variant", "view", "chart"});
    spec_.title = text_entry("title", path_.stem().string());
    spec_.purpose = text_entry("purpose", "");
    spec_.base = load_settings(scene_path());
    read_size();
    read_show();
    read_grid_px();
    read_measures();
    if (const TomlNode* set = table_entry("set"))
      apply_table(spec_.base, *set, path_.string(), path_.parent_path());
    for (const std::string& assignment : assignments) apply_assignment(spec_.base, assignment);
    read_axes();
    read_variants();
    read_views();
    check_assignments(assignments);
    spec_.assignments = assignments;
    check_count();
    spec_.charts = read_charts(document_, spec_);
    return std::move(spec_);
  }

 private:
  std::string at(const TomlNode& node) const { return path_.string() + ":" + std::to_string(node.line); }

  void check_keys(const TomlNode& table, const std::vector<std::string>& known) const {
    for (const auto& [key, node] : table.entries) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      throw input_error(at(node), "unknown entry '" + key + "'", suggest(key, known));
    }
  }

  std::string text_of(const TomlNode& node, const std::string& key) const {
    if (!node.is_text()) throw input_error(at(node), key + " is " + node.kind_name(), "it must be text");
    return node.text;
  }

  std::string text_entry(const std::string& key, const std::string& fallback) const {
    const TomlNode* node = document_.find(key);
    return node == nullptr ? fallback : text_of(*node, key);
  }

  const TomlNode* table_entry(const std::string& key) const {
    const TomlNode* node = document_.find(key);
    if (node != nullptr && !node->is_table()) {
      throw input_error(at(*node), key + " is " + node->kind_name(), "it must be a table: [" + key + "]");
    }
    return node;
  }

  /// Every table of a [[list]].
  std::vector<const TomlNode*> tables(const std::string& key) const {
    std::vector<const TomlNode*> result;
    const TomlNode* list = document_.find(key);
    if (list == nullptr) return result;
    const bool all_tables =
        list->is_array() && std::all_of(list->items.begin(), list->items.end(),
                                        [](const TomlNode& item) { return item.is_table(); });
    if (!all_tables)
      throw input_error(at(*list), key + " is " + list->kind_name(), "it must be tables: [[" + key + "]]");
    for (const TomlNode& item : list->items) result.push_back(&item);
    return result;
  }

  fs::path scene_path() const {
    const TomlNode* node = document_.find("scene");
    if (node == nullptr) return project_file("data/scenes/paper.toml");
    const std::string scene = text_of(*node, "scene");
    for (const fs::path& candidate : {path_.parent_path() / scene, project_root() / scene}) {
      std::error_code error;
      if (fs::is_regular_file(candidate, error)) return candidate;
    }
    throw input_error(at(*node), "scene \"" + scene + "\" was not found",
                      "give a path relative to this file or to " + project_root().string());
  }

  void read_size() {
    const TomlNode* node = document_.find("size");
    if (node == nullptr) return;
    const bool pair = node->is_array() && node->items.size() == 2;
    if (!pair)
      throw input_error(at(*node), "size is " + node->kind_name(), "it must be [width, height] in px");
    set_value("image.width", node->items[0], at(*node));
    set_value("image.height", node->items[1], at(*node));
  }

  void set_value(const std::string& key, const TomlNode& node, const std::string& where) {
    const Param param = find_param(spec_.base, key, where);
    param.set(value_from_toml(param, node, where, path_.parent_path().string()), where);
  }

  void read_show() {
    const TomlNode* node = document_.find("show");
    std::vector<std::string> names{"final"};
    if (node != nullptr) {
      if (!node->is_array())
        throw input_error(at(*node), "show is " + node->kind_name(),
                          "it must be a list of buffers: [\"final\"]");
      names.clear();
      for (const TomlNode& item : node->items) names.push_back(text_of(item, "show"));
    }
    spec_.show = parse_buffers(names, node == nullptr ? path_.string() : at(*node));
  }

  void read_grid_px() {
    const TomlNode* node = document_.find("grid_px");
    if (node == nullptr) return;
    const bool good = node->kind == TomlNode::Kind::integer && node->integer >= 32 && node->integer <= 16384;
    if (!good)
      throw input_error(at(*node), "grid_px is no side of a picture", "give a whole number from 32 to 16384");
    spec_.grid_px = static_cast<int>(node->integer);
  }

  void read_measures() {
    const TomlNode* node = document_.find("measure");
    if (node == nullptr) return;
    const std::vector<std::string> known = known_measures();
    if (node->kind == TomlNode::Kind::boolean) {
      if (node->boolean) spec_.measures = known;
      return;
    }
    if (!node->is_array()) {
      throw input_error(at(*node), "measure is " + node->kind_name(),
                        "it must be true, or a list of measures");
    }
    for (const TomlNode& item : node->items) {
      const std::string name = text_of(item, "measure");
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        throw input_error(at(item), "unknown measure '" + name + "'", suggest(name, known));
      }
      if (std::find(spec_.measures.begin(), spec_.measures.end(), name) == spec_.measures.end()) {
        spec_.measures.push_back(name);
      }
    }
  }

  void read_axes() {
    for (const TomlNode* table : tables("axis")) {
      check_keys(*table, {"key", "values", "label", "from", "to", "count", "scale"});
      const TomlNode* key = table->find("key");
      if (key == nullptr)
        throw input_error(at(*table), "an [[axis]] without a key", "give it one: key = \"combine.k_depth\"");
      Axis axis;
      axis.key = text_of(*key, "key");
      const Param param = find_param(spec_.base, axis.key, at(*key));
      for (const Axis& other : spec_.axes) {
        if (param.overlaps(find_param(spec_.base, other.key, at(*key)))) {
          throw input_error(at(*key), "a second axis over " + other.key, "each axis needs another key");
        }
      }
      const TomlNode* label = table->find("label");
      axis.label = label == nullptr ? axis.key.substr(axis.key.rfind('.') + 1) : text_of(*label, "label");
      axis.values =
          table->find("values") != nullptr ? listed_values(*table, param) : range_values(*table, param);
      spec_.axes.push_back(std::move(axis));
    }
    if (spec_.axes.size() > 3)
      throw input_error(path_.string(), fmt::format("has {} axes", spec_.axes.size()),
                        "at most three: columns, rows, pages");
  }

  std::vector<Value> listed_values(const TomlNode& table, const Param& param) const {
    const TomlNode& list = *table.find("values");
    for (const char* key : {"from", "to", "count", "scale"}) {
      if (const TomlNode* other = table.find(key)) {
        throw input_error(at(*other), std::string("both values and ") + key,
                          "give values, or from, to and count");
      }
    }
    if (!list.is_array()) throw input_error(at(list), "values is " + list.kind_name(), "it must be a list");
    if (list.items.empty())
      throw input_error(at(list), "the axis over " + param.key + " has no values", "list at least one");
    std::vector<Value> values;
    for (const TomlNode& item : list.items)
      values.push_back(
          checked(param, value_from_toml(param, item, at(item), path_.parent_path().string()), at(item)));
    return values;
  }

  static Value checked(const Param& param, const Value& value, const std::string& where) {
    check_value(*param.field, param.key, value, where);
    return value;
  }

  double number_entry(const TomlNode& table, const std::string& key) const {
    const TomlNode* node = table.find(key);
    if (node == nullptr)
      throw input_error(at(table), "the axis has no values and no " + key,
                        "give values, or from, to and count");
    if (node->kind == TomlNode::Kind::integer) return static_cast<double>(node->integer);
    if (node->kind == TomlNode::Kind::real && std::isfinite(node->real)) return node->real;
    throw input_error(at(*node), key + " is " + node->kind_name(), "it must be a finite number");
  }

  bool is_log(const TomlNode& table, const Param& param) const {
    const TomlNode* node = table.find("scale");
    if (node == nullptr) return param.field->scale == Scale::log;
    const std::string scale = text_of(*node, "scale");
    if (scale != "linear" && scale != "log")
      throw input_error(at(*node), "scale is \"" + scale + "\"", "one of: linear, log");
    return scale == "log";
  }

  std::vector<Value> range_values(const TomlNode& table, const Param& param) const {
    const double from = number_entry(table, "from");
    const double to = number_entry(table, "to");
    const double count = number_entry(table, "count");
    const bool log = is_log(table, param);
    const bool integer = param.field->type == FieldType::integer;
    if (!param.is_number()) {
      throw input_error(at(table),
                        "from and to need a number, and " + param.key + " is a " +
                            std::string(type_name(param.field->type)),
                        "give values instead");
    }
    if (count < 1 || count > kMaxAxisCount || count != std::floor(count)) {
      throw input_error(at(*table.find("count")), "count = " + shortest(count),
                        "it must be a whole number from 1 to " + with_commas(kMaxAxisCount));
    }
    for (const double end : {from, to}) checked(param, static_cast<float>(end), at(table));
    if (log && (from <= 0 || to <= 0))
      throw input_error(at(table), "a log axis from " + shortest(from) + " to " + shortest(to),
                        "both must be above 0");
    std::vector<Value> values;
    for (int i = 0; i < static_cast<int>(count); ++i) {
      const double t = count > 1 ? i / (count - 1) : 0.0;
      const double number = i == count - 1 && count > 1 ? to
                            : log                       ? from * std::pow(to / from, t)
                                                        : from + (to - from) * t;
      const Value value =
          integer ? Value(static_cast<int>(std::lround(number))) : Value(static_cast<float>(number));
      if (values.empty() || values.back() != value) values.push_back(checked(param, value, at(table)));
    }
    return values;
  }

  void read_variants() {
    const std::vector<const TomlNode*> found = tables("variant");
    spec_.variants = named_sets("variant", found);
    if (!spec_.variants.empty() && spec_.axes.size() > 2)
      throw input_error(at(*found.front()), "three [[axis]] and [[variant]]",
                        "columns, rows and pages are all taken: at most two axes beside variants");
    for (size_t i = 0; i < spec_.variants.size(); ++i) {
      for (const Assignment& assignment : spec_.variants[i].set) {
        check_not_an_axis(assignment.key, "variant", at(*found[i]));
      }
    }
  }

  void read_views() {
    const std::vector<const TomlNode*> found = tables("view");
    spec_.views = named_sets("view", found);
    for (size_t i = 0; i < spec_.views.size(); ++i) {
      const std::string where = at(*found[i]);
      check_view_name(spec_.views[i].name, where);
      for (const Assignment& assignment : spec_.views[i].set) check_not_varied(assignment.key, where);
    }
  }

  /// It becomes part of file names.
  static void check_view_name(const std::string& name, const std::string& where) {
    const bool good = !name.empty() && name.size() <= 40 && std::all_of(name.begin(), name.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
    if (good) return;
    throw input_error(where, "a view is named \"" + name + "\"",
                      "its files bear its name: use 1 to 40 of a-z, 0-9, - and _");
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
    return find_param(spec_.base, key, key).overlaps(find_param(spec_.base, other, other));
  }

  /// Every [[variant]] or [[view]]: a name and what it sets.
  std::vector<NamedSet> named_sets(const std::string& kind, const std::vector<const TomlNode*>& found) {
    std::vector<NamedSet> sets;
    if (document_.find(kind) != nullptr && found.empty())
      throw input_error(at(*document_.find(kind)), "an empty list of " + kind + "s");
    for (const TomlNode* table : found) {
      check_keys(*table, {"name", "set"});
      const TomlNode* name = table->find("name");
      if (name == nullptr)
        throw input_error(at(*table), "a [[" + kind + "]] without a name", "give it one: name = \"front\"");
      NamedSet set{text_of(*name, "name"), {}};
      for (const NamedSet& other : sets) {
        if (other.name == set.name)
          throw input_error(at(*name), "a second " + kind + " is named \"" + set.name + "\"",
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
      throw input_error(at(table), "set is " + table.kind_name(), "it must be a table: [" + kind + ".set]");
    std::vector<Assignment> result;
    visit_table(spec_.base, table, "", path_.string(), [&](const Param& param, const TomlNode& node) {
      const Value value = value_from_toml(param, node, at(node), path_.parent_path().string());
      result.push_back({param.key, checked(param, value, at(node))});
    });
    return result;
  }

  void check_assignments(const std::vector<std::string>& assignments) {
    for (const std::string& assignment : assignments) {
      const std::string key(trim(assignment.substr(0, assignment.find('='))));
      for (const Axis& axis : spec_.axes) {
        const Param set = find_param(spec_.base, key, "--set " + assignment);
        const Param varied = find_param(spec_.base, axis.key, axis.key);
        // A whole vector may be set under an axis over one of its components: the others take the new values.
        const bool is_lost = varied.overlaps(set) && (varied.component < 0 || set.component >= 0);
        if (is_lost)
          throw input_error("--set " + assignment, "is what the study's axis varies",
                            "edit the axis in " + path_.string());
      }
      check_not_in_views(assignment, key);
    }
  }

  void check_not_in_views(const std::string& assignment, const std::string& key) {
    const Param param = find_param(spec_.base, key, "--set " + assignment);
    for (const NamedSet& view : spec_.views) {
      for (const Assignment& own : view.set) {
        if (!param.overlaps(find_param(spec_.base, own.key, own.key))) continue;
        throw input_error("--set " + assignment, "is what the study's views set",
                          "edit the views in " + path_.string());
      }
    }
  }

  void check_count() const {
    auto count = static_cast<double>(std::max<size_t>(1, spec_.variants.size()));
    for (const Axis& axis : spec_.axes) count *= static_cast<double>(axis.values.size());
    if (count > kMaxCells)
      throw input_error(path_.string(), fmt::format("{:.0f} cells", count),
                        "at most " + with_commas(kMaxCells));
    const TomlNode* axes = document_.find("axis");
    if (axes != nullptr && axes->items.empty()) throw input_error(at(*axes), "an empty list of axes");
  }

  fs::path path_;
  TomlNode document_;
  StudySpec spec_;
};

}  // namespace

StudySpec load_spec(const fs::path& path, const std::vector<std::string>& assignments) {
  return parse_spec(read_file(path), path, assignments);
}

StudySpec parse_spec(const std::string& text, const fs::path& name,
                     const std::vector<std::string>& assignments) {
  return SpecReader(text, name).read(assignments);
}

}  // namespace inkbench
