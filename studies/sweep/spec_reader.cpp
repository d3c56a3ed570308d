// SPDX-License-Identifier: MIT
// Specs as they are read: TOML in, a StudySpec whose every entry was looked at out.
#include <fmt/format.h>

#include <algorithm>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/levels/scene_file.h"
#include "pipeline/params/toml_reader.h"
#include "pipeline/params/toml_value.h"
#include "pipeline/settings/settings_file.h"
#include "studies/sweep/chart_spec.h"
#include "studies/sweep/number_columns.h"
#include "studies/sweep/spec.h"
#include "studies/sweep/spec_axes.h"
#include "studies/sweep/spec_base.h"
#include "studies/sweep/spec_sets.h"

namespace inkbench {
namespace {

constexpr size_t kMaxCells = 10'000'000;

/// Reading one spec: the document, its name for errors and the folder that relative paths start from.
class SpecReader {
 public:
  SpecReader(const std::string& text, const fs::path& path)
      : path_(path), toml_(path.string()), document_(parse_toml(text, path.string())) {
    spec_.path = path;
    spec_.text = text;
  }

  StudySpec read(const std::vector<std::string>& assignments) {
    toml_.check_keys(document_, {"title", "purpose", "scene", "size", "show", "grid_px", "measure", "pr",
                                 "set", "axis", "variant", "view", "path", "chart"});
    spec_.title = toml_.text_entry(document_, "title", path_.stem().string());
    spec_.purpose = toml_.text_entry(document_, "purpose", "");
    spec_.base = read_base(document_, path_, assignments);
    read_show();
    read_grid_px();
    if (const TomlNode* path = document_.find("path")) spec_.camera_path = read_path(*path, path_.string());
    read_measures();
    read_curves();
    spec_.axes = read_axes(document_, spec_);
    spec_.variants = read_variants(document_, spec_);
    spec_.views = read_views(document_, spec_);
    check_assignments(assignments);
    spec_.assignments = assignments;
    check_count();
    spec_.charts = read_charts(document_, spec_);
    return std::move(spec_);
  }

 private:
  void read_show() {
    const TomlNode* node = document_.find("show");
    std::vector<std::string> names{"final"};
    if (node != nullptr) {
      if (!node->is_array())
        throw input_error(toml_.at(*node), "show is " + node->kind_name(),
                          "it must be a list of buffers: [\"final\"]");
      names.clear();
      for (const TomlNode& item : node->items) names.push_back(toml_.text_of(item, "show"));
    }
    spec_.show = parse_buffers(names, node == nullptr ? path_.string() : toml_.at(*node));
  }

  void read_grid_px() {
    const TomlNode* node = document_.find("grid_px");
    if (node == nullptr) return;
    const bool good = node->kind == TomlNode::Kind::integer && node->integer >= 32 && node->integer <= 16384;
    if (!good)
      throw input_error(toml_.at(*node), "grid_px is no side of a picture",
                        "give a whole number from 32 to 16384");
    spec_.grid_px = static_cast<int>(node->integer);
  }

  void read_measures() {
    const TomlNode* node = document_.find("measure");
    if (node == nullptr) return;
    const std::vector<std::string> known = known_measures();
    if (node->kind == TomlNode::Kind::boolean) {
      if (node->boolean) spec_.measures = every_measure(spec_.camera_path.has_value());
      return;
    }
    if (!node->is_array()) {
      throw input_error(toml_.at(*node), "measure is " + node->kind_name(),
                        "it must be true, or a list of measures");
    }
    for (const TomlNode& item : node->items) add_measure(item, known);
  }

  void read_curves() {
    const TomlNode* node = document_.find("pr");
    if (node == nullptr) return;
    if (node->kind != TomlNode::Kind::boolean)
      throw input_error(toml_.at(*node), "pr is " + node->kind_name(), "it must be true or false");
    spec_.curves = node->boolean;
    for (const char* key : {"ods", "ois", "ap"}) {
      const bool is_new =
          std::find(spec_.measures.begin(), spec_.measures.end(), key) == spec_.measures.end();
      if (spec_.curves && is_new) spec_.measures.emplace_back(key);
    }
  }

  void add_measure(const TomlNode& item, const std::vector<std::string>& known) {
    const std::string name = toml_.text_of(item, "measure");
    const std::string_view new_name = renamed_measure(name);
    if (!new_name.empty())
      throw input_error(toml_.at(item), "the measure '" + name + "' has another name now",
                        "write \"" + std::string(new_name) + "\"");
    if (const Measure* measure = find_measure(name); measure != nullptr && measure->of_marks())
      throw input_error(toml_.at(item),
                        "the measure '" + name + "' looks at a person's marks, and a study has none",
                        "search with them: `inkbench tune` and [[marks]]");
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw input_error(toml_.at(item), "unknown measure '" + name + "'", suggest(name, known));
    const bool compares_frames = find_measure(name)->of_path();
    if (compares_frames && !spec_.camera_path)
      throw input_error(toml_.at(item),
                        "the measure '" + name + "' compares the frames of a path, and there is none",
                        "add a table [path], such as frames = 36");
    const auto add = [&](const std::string& key) {
      const bool is_new =
          std::find(spec_.measures.begin(), spec_.measures.end(), key) == spec_.measures.end();
      if (is_new) spec_.measures.push_back(key);
    };
    if (compares_frames) add("recall");  // an empty drawing does not flicker
    add(name);
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
    const double frames = spec_.camera_path ? count * spec_.camera_path->frames : 0;
    if (frames > kMaxCells)
      throw input_error(path_.string(), fmt::format("{:.0f} frames in all cells", frames),
                        "at most " + with_commas(kMaxCells));
  }

  fs::path path_;
  TomlReader toml_;
  TomlNode document_;
  StudySpec spec_;
};

}  // namespace

StudySpec load_spec(const fs::path& path, const std::vector<std::string>& assignments) {
  if (!is_utf8(path.string()))
    throw input_error(path.string(), "has a name that is not UTF-8", "rename the file");
  return parse_spec(read_file(path, kMostTextBytes), path, assignments);
}

StudySpec parse_spec(const std::string& text, const fs::path& name,
                     const std::vector<std::string>& assignments) {
  return SpecReader(text, name).read(assignments);
}

}  // namespace inkbench
