// SPDX-License-Identifier: MIT
#include "studies/sweep/spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/stop.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/levels/model_mesh.h"

namespace inkbench {
namespace {

void check_file(const std::string& key, const std::string& path) {
  if (path.empty()) return;
  std::error_code error;
  if (is_named_mesh(path)) {
    mesh_path(path);
  } else if (!fs::is_regular_file(path, error)) {
    throw input_error(key, "there is no file " + path);
  }
}

void check_files(const Settings& settings, std::set<std::string>& seen) {
  for (const ModelParams& model : settings.models) {
    if (!model.visible || model.shape != Shape::mesh || !seen.insert(model.mesh).second) continue;
    check_file("model." + model.name + ".mesh", model.mesh);
  }
  check_file("ramp.diffuse", settings.ramp.diffuse.image);
  check_file("ramp.specular", settings.ramp.specular.image);
}

}  // namespace

size_t cell_count(const StudySpec& spec) {
  size_t count = std::max<size_t>(1, spec.variants.size());
  for (const Axis& axis : spec.axes) count *= axis.values.size();
  return count;
}

Cell make_cell(const StudySpec& spec, size_t index) {
  Cell cell;
  cell.index = index;
  int* const places[] = {&cell.column, &cell.row, &cell.page};
  std::vector<std::string> parts;
  size_t rest = index;
  for (size_t i = 0; i < spec.axes.size(); ++i) {
    const Axis& axis = spec.axes[i];
    *places[i] = static_cast<int>(rest % axis.values.size());
    rest /= axis.values.size();
    cell.set.push_back({axis.key, axis.values[*places[i]]});
    parts.push_back(axis.short_key + " = " + axis.value_labels[*places[i]]);
  }
  if (!spec.variants.empty()) {
    const NamedSet& variant = spec.variants[rest];
    *places[spec.axes.size()] = static_cast<int>(rest);
    cell.set.insert(cell.set.end(), variant.set.begin(), variant.set.end());
    cell.variant = variant.name;
    parts.insert(parts.begin(), variant.name);
  }
  cell.name = join(parts, ", ");
  return cell;
}

Settings cell_settings(const StudySpec& spec, const Cell& cell) {
  Settings settings = spec.base;
  for (const Assignment& assignment : cell.set) {
    find_param(settings, assignment.key, cell.name).set(assignment.value, cell.name);
  }
  return settings;
}

size_t view_count(const StudySpec& spec) {
  return std::max<size_t>(1, spec.views.size());
}

size_t picture_count(const StudySpec& spec) {
  return view_count(spec) * spec.show.size();
}

Settings view_settings(const StudySpec& spec, const Cell& cell, size_t view) {
  Settings settings = cell_settings(spec, cell);
  if (spec.camera_path) return settings_at(*spec.camera_path, settings, static_cast<int>(view));
  if (spec.views.empty()) return settings;
  for (const Assignment& assignment : spec.views[view].set) {
    find_param(settings, assignment.key, spec.views[view].name).set(assignment.value, spec.views[view].name);
  }
  return settings;
}

void check_cells(const StudySpec& spec) {
  std::set<std::string> seen;
  for (size_t i = 0; i < cell_count(spec) * view_count(spec); ++i) {
    stop_if_asked();
    const Cell cell = make_cell(spec, i / view_count(spec));
    const size_t view = i % view_count(spec);
    try {
      const Settings settings = view_settings(spec, cell, view);
      check_settings(settings);
      check_files(settings, seen);
    } catch (const Error& error) {
      std::string where = spec.path.string();
      if (!cell.name.empty()) where += ", cell " + cell.name;
      if (!spec.views.empty()) where += ", view " + spec.views[view].name;
      throw input_error(where, error.what());
    }
  }
}

}  // namespace inkbench
