// SPDX-License-Identifier: MIT
// A study's spec: base settings, what varies (axes or named variants), what each cell shows. Read from TOML
// and validated whole: a spec that was read has only cells that can be started.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/buffers.h"
#include "pipeline/settings/camera_path.h"
#include "pipeline/settings/settings.h"
#include "studies/report/chart.h"

namespace inkbench {

struct Axis {
  std::string key;
  std::string short_key;                  ///< Of `key_labels` over all axes.
  std::string label;                      ///< `short_key` unless the spec says more.
  std::vector<Value> values;              ///< At least one.
  std::vector<std::string> value_labels;  ///< `label_texts` of them.
};

struct Assignment {
  std::string key;
  Value value;
};

/// A variant, which is a cell of its own, or a view, which is a part of every cell.
struct NamedSet {
  std::string name;
  std::vector<Assignment> set;
};

struct StudySpec {
  std::filesystem::path path;
  std::string text;  ///< The file's content.
  std::string title;
  std::string purpose;  ///< One line for `inkbench study list`.
  Settings base;
  std::vector<BufferName> show;
  int grid_px = 0;                    ///< Longer side of a picture in the grid; 0 as it is.
  std::vector<std::string> measures;  ///< Of the drawn lines against the reference; columns of data.csv.
  bool curves = false;                ///< Precision and recall over thresholds: `pr = true`.
  std::vector<Axis> axes;             ///< Columns, rows, pages: at most three, at most two beside variants.
  std::vector<NamedSet> variants;     ///< Laid out where the axes end: columns, rows or pages.
  /// What each cell is drawn and measured from, all together: cameras, as a rule. Empty: once, as it is.
  std::vector<NamedSet> views;
  std::optional<CameraPath> camera_path;  ///< Its frames are the views, which set nothing else.
  std::vector<std::string> assignments;   ///< `--set` texts that came on top.
  std::vector<Chart> charts;              ///< Of data.csv.
};

/// One cell: its place in the grid and what it changes.
struct Cell {
  size_t index = 0;  ///< In order of page, row, column.
  int column = 0, row = 0, page = 0;
  std::string name;     ///< "k_depth = 0.001, k_normal = 0.005", for people.
  std::string variant;  ///< Its name; empty where there are none.
  std::vector<Assignment> set;
};

/// Errors (input): file:line for broken TOML, unknown keys, values that the parameter does not accept, axes
/// without values, missing files; the cell whose settings contradict each other. `assignments` are `--set`
/// texts on top of [set].
StudySpec load_spec(const std::filesystem::path& path, const std::vector<std::string>& assignments = {});

/// The same from text; `name` stands for the file in errors.
StudySpec parse_spec(const std::string& text, const std::filesystem::path& name,
                     const std::vector<std::string>& assignments);

size_t cell_count(const StudySpec& spec);
Cell make_cell(const StudySpec& spec, size_t index);

/// Base plus the cell's overrides.
Settings cell_settings(const StudySpec& spec, const Cell& cell);

/// At least 1: a spec without views has one without a name.
size_t view_count(const StudySpec& spec);

/// Of each cell: a picture of every shown buffer in every view.
size_t picture_count(const StudySpec& spec);

/// The cell seen from one of the spec's views.
Settings view_settings(const StudySpec& spec, const Cell& cell, size_t view);

/// Checks every cell's settings and that the files they name exist. Errors (input): the first cell that is
/// wrong.
void check_cells(const StudySpec& spec);

}  // namespace inkbench
