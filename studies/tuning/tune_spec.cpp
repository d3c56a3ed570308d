// SPDX-License-Identifier: MIT
#include "studies/tuning/tune_spec.h"

#include <algorithm>
#include <cmath>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/params/toml_reader.h"
#include "pipeline/params/toml_value.h"
#include "pipeline/settings/settings_file.h"
#include "studies/sweep/spec_axes.h"
#include "studies/sweep/spec_base.h"
#include "studies/sweep/spec_sets.h"

namespace inkbench {
namespace {

class TuneSpecReader {
 public:
  TuneSpecReader(const std::string& text, const fs::path& path)
      : path_(path), toml_(path.string()), document_(parse_toml(text, path.string())) {
    spec_.path = path;
    spec_.text = text;
  }

  TuneSpec read(const std::vector<std::string>& assignments) {
    toml_.check_keys(document_, {"title", "purpose", "like", "scene", "size", "set", "view", "group",
                                 "leave_out", "marks", "search", "objective", "budget", "seed"});
    spec_.title = toml_.text_entry(document_, "title", path_.stem().string());
    spec_.purpose = toml_.text_entry(document_, "purpose", "");
    if (const TomlNode* like = document_.find("like")) {
      take_pictures(*like);
    } else {
      spec_.base = read_base(document_, path_, {});
      read_pictures();
    }
    for (const std::string& assignment : assignments) apply_assignment(spec_.base, assignment);
    spec_.assignments = assignments;
    read_marks_tables();
    read_search();
    read_objective();
    spec_.budget = static_cast<int>(whole("budget", spec_.budget, kLeastBudget, kMostBudget));
    spec_.seed = static_cast<uint64_t>(whole("seed", 1, 0, 1e9));
    return std::move(spec_);
  }

 private:
  double whole(const std::string& key, double fallback, double least, double most) const {
    const TomlNode* node = document_.find(key);
    if (node == nullptr) return fallback;
    const double number = toml_.number_of(*node, key);
    if (number >= least && number <= most && number == std::floor(number)) return number;
    throw input_error(toml_.at(*node), key + " = " + shortest(number),
                      "it must be a whole number from " + shortest(least) + " to " + shortest(most));
  }

  /// Those of another search, with [set] on top.
  void take_pictures(const TomlNode& like) {
    for (const char* key : {"scene", "size", "view", "group", "leave_out"}) {
      if (const TomlNode* node = document_.find(key))
        throw input_error(toml_.at(*node), std::string(key) + " beside like",
                          "the pictures are those of the other search: leave one of them out");
    }
    const fs::path path = path_.parent_path() / toml_.text_of(like, "like");
    if (fs::weakly_canonical(path) == fs::weakly_canonical(path_))
      throw input_error(toml_.at(like), "like names this file itself", "name another search");
    const std::string text = read_file(path, kMostTextBytes);
    if (parse_toml(text, path.string()).find("like") != nullptr)
      throw input_error(toml_.at(like), path.string() + " takes its pictures from another search, too",
                        "name that one");
    TuneSpec other = parse_tune_spec(text, path);
    spec_.base = std::move(other.base);
    spec_.pictures = std::move(other.pictures);
    spec_.groups = std::move(other.groups);
    spec_.group_kind = std::move(other.group_kind);
    if (const TomlNode* set = document_.find("set"))
      apply_table(spec_.base, *set, path_.string(), path_.parent_path());
  }

  /// Every group from every view.
  void read_pictures() {
    StudySpec shell;
    shell.path = path_;
    shell.base = spec_.base;
    std::vector<NamedSet> groups = read_sets(document_, "group", shell);
    shell.variants = groups;
    std::vector<NamedSet> views = read_views(document_, shell);
    const bool has_groups = !groups.empty(), has_views = !views.empty();
    if (!has_groups) groups.push_back({has_views ? "" : "all", {}});
    if (!has_views) views.push_back({"", {}});
    const bool by_view = leaves_out_views(has_groups, has_views);
    spec_.group_kind = by_view ? "view" : "group";
    for (const NamedSet& group : by_view ? views : groups) spec_.groups.push_back(group.name);
    for (size_t g = 0; g < groups.size(); ++g) {
      for (size_t v = 0; v < views.size(); ++v) {
        const bool is_pair = !groups[g].name.empty() && !views[v].name.empty();
        TunePicture picture;
        picture.name = groups[g].name + (is_pair ? "_" : "") + views[v].name;
        picture.group = by_view ? v : g;
        picture.of_group = has_groups ? groups[g].name : "";
        picture.of_view = views[v].name;
        picture.set = groups[g].set;
        picture.set.insert(picture.set.end(), views[v].set.begin(), views[v].set.end());
        spec_.pictures.push_back(std::move(picture));
      }
    }
  }

  /// What is asked for in particular pictures is not left out in turn, unless the spec says so.
  void read_marks_tables() {
    const std::vector<const TomlNode*> tables = toml_.tables(document_, "marks");
    for (const TomlNode* table : tables) {
      toml_.check_keys(*table, {"group", "view", "file"});
      TunePicture& picture = spec_.pictures[picture_of(*table)];
      if (picture.marks)
        throw input_error(toml_.at(*table), "second marks of the same picture", "put them into one file");
      const TomlNode* file = table->find("file");
      if (file == nullptr)
        throw input_error(toml_.at(*table), "[[marks]] without a file", "name it: file = \"front.png\"");
      const Settings settings = picture_settings(spec_, picture);
      picture.marks = read_marks(path_.parent_path() / toml_.text_of(*file, "file"), settings.image.width,
                                 settings.image.height);
    }
    if (tables.empty() || document_.find("leave_out") != nullptr) return;
    spec_.groups = {"all"};
    for (TunePicture& picture : spec_.pictures) picture.group = 0;
  }

  /// The picture that a table's group and view name.
  size_t picture_of(const TomlNode& table) const {
    const std::string group = place_entry(table, "group", &TunePicture::of_group);
    const std::string view = place_entry(table, "view", &TunePicture::of_view);
    const auto found = std::find_if(
        spec_.pictures.begin(), spec_.pictures.end(),
        [&](const TunePicture& picture) { return picture.of_group == group && picture.of_view == view; });
    return static_cast<size_t>(found - spec_.pictures.begin());
  }

  /// One of the spec's groups or views; "" where it has none.
  std::string place_entry(const TomlNode& table, const std::string& kind,
                          std::string TunePicture::*name) const {
    std::vector<std::string> known;
    for (const TunePicture& picture : spec_.pictures) {
      if (std::find(known.begin(), known.end(), picture.*name) == known.end()) known.push_back(picture.*name);
    }
    const TomlNode* node = table.find(kind);
    if (node == nullptr) {
      if (known.size() == 1) return known.front();
      throw input_error(toml_.at(table), "[[marks]] without a " + kind, "one of: " + join(known, ", "));
    }
    const std::string text = toml_.text_of(*node, kind);
    if (std::find(known.begin(), known.end(), text) != known.end()) return text;
    throw input_error(toml_.at(*node), "there is no " + kind + " '" + text + "'",
                      known == std::vector<std::string>{""} ? "leave it out" : suggest(text, known));
  }

  bool leaves_out_views(bool has_groups, bool has_views) const {
    const TomlNode* node = document_.find("leave_out");
    if (node == nullptr) return !has_groups && has_views;
    const std::string kind = toml_.text_of(*node, "leave_out");
    if (kind != "group" && kind != "view")
      throw input_error(toml_.at(*node), "leave_out is \"" + kind + "\"", "one of: group, view");
    const bool is_there = kind == "group" ? has_groups : has_views;
    if (!is_there)
      throw input_error(toml_.at(*node), "leave_out = \"" + kind + "\", and there is no [[" + kind + "]]",
                        "add one, or leave the line out");
    return kind == "view";
  }

  void read_search() {
    const std::vector<const TomlNode*> tables = toml_.tables(document_, "search");
    if (tables.empty())
      throw input_error(path_.string(), "has no [[search]]",
                        "name the parameters to search: [[search]], key = \"combine.k_depth\"");
    for (const TomlNode* table : tables) {
      const SearchAxis axis = read_axis(*table);
      check_not_set(axis.key, toml_.at(*table));
      spec_.space.push_back(axis);
    }
  }

  SearchAxis read_axis(const TomlNode& table) {
    toml_.check_keys(table, {"key", "from", "to", "scale", "values"});
    const TomlNode* key = table.find("key");
    if (key == nullptr)
      throw input_error(toml_.at(table), "a [[search]] without a key",
                        "give it one: key = \"combine.k_depth\"");
    SearchAxis axis = default_axis(spec_.base, toml_.text_of(*key, "key"), toml_.at(*key));
    if (const TomlNode* values = table.find("values")) {
      read_values(axis, *values);
      return axis;
    }
    for (const auto& [name, end] : {std::pair("from", &axis.from), std::pair("to", &axis.to)}) {
      const TomlNode* node = table.find(name);
      if (node == nullptr) continue;
      if (!axis.is_number())
        throw input_error(toml_.at(*node),
                          std::string(name) + " needs a number, and " + axis.key + " is none",
                          "list values instead, or leave it out for all of them");
      *end = toml_.number_of(*node, name);
      check_end(axis, *end, toml_.at(*node));
    }
    read_scale(axis, table);
    if (axis.is_number() && axis.from >= axis.to)
      throw input_error(
          toml_.at(table),
          "a search from " + shortest(axis.from) + " to " + shortest(axis.to) + " of " + axis.key,
          "from must be below to");
    return axis;
  }

  void check_end(const SearchAxis& axis, double end, const std::string& where) {
    const Param param = find_param(spec_.base, axis.key, where);
    if (axis.is_whole && end != std::floor(end))
      throw input_error(where, shortest(end) + " is no value of " + axis.key, "it takes whole numbers");
    const Value value = axis.is_whole ? Value(static_cast<int>(end)) : Value(static_cast<float>(end));
    check_value(*param.field, param.key, value, where);
  }

  void read_scale(SearchAxis& axis, const TomlNode& table) const {
    axis.scale = scale_entry(toml_, table, axis.scale);
    if (axis.is_number() && axis.scale == Scale::log && axis.from <= 0)
      throw input_error(toml_.at(table), "a log search from " + shortest(axis.from) + " of " + axis.key,
                        "from must be above 0, or scale = \"linear\"");
  }

  void read_values(SearchAxis& axis, const TomlNode& list) {
    const Param param = find_param(spec_.base, axis.key, toml_.at(list));
    axis.choices.clear();
    for (const TomlNode& item : toml_.items_of(list, "values")) {
      const Value value = value_from_toml(param, item, toml_.at(item), path_.parent_path().string());
      check_value(*param.field, param.key, value, toml_.at(item));
      axis.choices.push_back(value);
    }
    if (axis.choices.empty())
      throw input_error(toml_.at(list), "the search over " + axis.key + " has no values",
                        "list at least two");
  }

  void check_not_set(const std::string& key, const std::string& where) {
    const Param param = find_param(spec_.base, key, where);
    for (const SearchAxis& other : spec_.space) {
      if (param.overlaps(find_param(spec_.base, other.key, where)))
        throw input_error(where, "a second search over " + other.key, "each needs another key");
    }
    for (const TunePicture& picture : spec_.pictures) {
      for (const Assignment& assignment : picture.set) {
        if (param.overlaps(find_param(spec_.base, assignment.key, where)))
          throw input_error(where, key + " is searched, and " + picture.name + " sets it",
                            "let one of them set it");
      }
    }
  }

  void read_objective() {
    const TomlNode* table = document_.find("objective");
    const bool with_reference = table == nullptr || reads_reference(*table);
    spec_.objective = spec_.has_marks() ? marks_objective(with_reference) : default_objective();
    if (table != nullptr) read_terms(*table);
    const std::string where = table == nullptr ? path_.string() : toml_.at(*table);
    if (!with_reference) check_no_reference(where);
    check_marks(where);
  }

  bool reads_reference(const TomlNode& table) const {
    const TomlNode* node = table.find("reference");
    if (node == nullptr) return true;
    if (node->kind != TomlNode::Kind::boolean)
      throw input_error(toml_.at(*node), "reference is " + node->kind_name(), "it must be true or false");
    return node->boolean;
  }

  void check_no_reference(const std::string& where) const {
    for (const Measure* measure : spec_.objective.measures()) {
      MeasureNeeds needs;
      needs.add(*measure);
      if (needs.reference_lines())
        throw input_error(where, measure->key + " needs reference lines, and reference = false",
                          "leave that line out, or look at marks alone");
    }
  }

  /// Marks are looked at, and what looks at marks alone has them everywhere.
  void check_marks(const std::string& where) const {
    const std::vector<const Measure*> measures = spec_.objective.measures();
    const auto of_marks = std::count_if(measures.begin(), measures.end(),
                                        [](const Measure* measure) { return measure->of_marks(); });
    if (of_marks > 0 && !spec_.has_marks())
      throw input_error(where, "the objective looks at marks, and there are none",
                        "add [[marks]] with a file");
    if (of_marks == 0 && spec_.has_marks())
      throw input_error(where, "there are [[marks]], and the objective looks at none of them",
                        "add marks = 1 to [objective]");
    const bool are_alone = of_marks > 0 && of_marks == static_cast<long>(measures.size());
    for (const TunePicture& picture : spec_.pictures) {
      if (are_alone && !picture.marks)
        throw input_error(where, picture.name + " has no marks, and the objective looks at nothing else",
                          "give it [[marks]], or leave it out");
    }
  }

  void read_terms(const TomlNode& table) {
    std::vector<ObjectiveTerm> terms;
    for (const auto& [key, node] : toml_.entries_of(table, "objective")) {
      if (key == "reference") continue;
      if (key == "constraints") {
        for (const TomlNode& item : toml_.items_of(node, key))
          spec_.objective.constraints.push_back(parse_constraint(toml_.text_of(item, key), toml_.at(item)));
      } else {
        terms.push_back(read_term(key, node));
      }
    }
    if (!terms.empty()) spec_.objective.terms = terms;
  }

  ObjectiveTerm read_term(const std::string& key, const TomlNode& node) const {
    const Measure& measure = searchable_measure(key, toml_.at(node));
    if (measure.better == Better::neither)
      throw input_error(toml_.at(node), "neither more nor less of " + key + " is better",
                        "limit it: constraints = [\"" + key + " <= 0.05\"]");
    const double weight = toml_.number_of(node, key);
    if (weight <= 0)
      throw input_error(toml_.at(node), key + " has the weight " + shortest(weight),
                        "it must be above 0; what should be little counts against the sum by itself");
    return {&measure, weight};
  }

  fs::path path_;
  TomlReader toml_;
  TomlNode document_;
  TuneSpec spec_;
};

}  // namespace

bool TuneSpec::has_marks() const {
  return std::any_of(pictures.begin(), pictures.end(),
                     [](const TunePicture& picture) { return picture.marks.has_value(); });
}

TuneSpec load_tune_spec(const fs::path& path, const std::vector<std::string>& assignments) {
  if (!is_utf8(path.string()))
    throw input_error(path.string(), "has a name that is not UTF-8", "rename the file");
  return parse_tune_spec(read_file(path, kMostTextBytes), path, assignments);
}

TuneSpec parse_tune_spec(const std::string& text, const fs::path& name,
                         const std::vector<std::string>& assignments) {
  return TuneSpecReader(text, name).read(assignments);
}

SearchAxis default_axis(const Settings& settings, const std::string& key, const std::string& where) {
  const ConstParam param = find_param(settings, key, where);
  const Field& field = *param.field;
  SearchAxis axis;
  axis.key = param.key;
  axis.scale = field.scale;
  if (field.type == FieldType::boolean) axis.choices = {false, true};
  for (const std::string_view choice : field.choices) axis.choices.emplace_back(std::string(choice));
  if (!axis.choices.empty()) return axis;
  if (!param.is_number())
    throw input_error(where,
                      key + " is a " + std::string(type_name(field.type)) + ", which cannot be searched",
                      "numbers, choices, booleans and components of vectors can");
  axis.from = field.slider.low;
  axis.to = field.slider.high;
  axis.is_whole = field.type == FieldType::integer;
  return axis;
}

Settings picture_settings(const TuneSpec& spec, const TunePicture& picture) {
  Settings settings = spec.base;
  for (const Assignment& assignment : picture.set)
    find_param(settings, assignment.key, picture.name).set(assignment.value, picture.name);
  return settings;
}

TuneProblem problem_of(const TuneSpec& spec) {
  const Settings paper;
  TuneProblem problem{spec.space, spec.objective, spec.base, spec.groups, values_of(spec.space, spec.base),
                      {},         spec.budget,    spec.seed};
  Values papers = problem.start;
  for (size_t i = 0; i < spec.space.size(); ++i) {
    if (has_param(paper, spec.space[i].key))
      papers[i] = find_param(paper, spec.space[i].key, spec.space[i].key).value();
  }
  if (papers != problem.start) problem.others.push_back(papers);
  return problem;
}

}  // namespace inkbench
