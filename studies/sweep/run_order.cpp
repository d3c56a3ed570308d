// SPDX-License-Identifier: MIT
#include <algorithm>

#include "studies/sweep/run_study.h"

namespace inkbench {
namespace {

int axis_cost(Pipeline& pipeline, const StudySpec& spec, const Axis& axis) {
  const auto frame_at = [&](const Value& value) {
    Settings settings = spec.base;
    find_param(settings, axis.key, axis.key).set(value, axis.key);
    return pipeline.at(settings);
  };
  return frame_at(axis.values.back()).cost_after(frame_at(axis.values.front()));
}

int view_cost(Pipeline& pipeline, const StudySpec& spec) {
  const Cell cell = make_cell(spec, 0);
  return pipeline.at(view_settings(spec, cell, view_count(spec) - 1))
      .cost_after(pipeline.at(view_settings(spec, cell, 0)));
}

int variant_cost(Pipeline& pipeline, const StudySpec& spec) {
  const size_t stride = cell_count(spec) / spec.variants.size();
  const Cell first = make_cell(spec, 0), last = make_cell(spec, cell_count(spec) - stride);
  const int cost = pipeline.at(cell_settings(spec, last)).cost_after(pipeline.at(cell_settings(spec, first)));
  return cost + 1;  // outside an axis of equal cost
}

/// A loop over one axis, over the variants, or over the views.
struct Loop {
  size_t count = 1, cell_stride = 0, view_stride = 0;
  int cost = 0;
};

/// From the innermost as the grid has them: views, columns, rows, pages.
std::vector<Loop> make_loops(Pipeline& pipeline, const StudySpec& spec) {
  std::vector<Loop> loops{{view_count(spec), 0, 1, view_cost(pipeline, spec)}};
  size_t stride = 1;
  for (const Axis& axis : spec.axes) {
    loops.push_back({axis.values.size(), stride, 0, axis_cost(pipeline, spec, axis)});
    stride *= axis.values.size();
  }
  if (!spec.variants.empty()) {
    loops.push_back({spec.variants.size(), stride, 0, variant_cost(pipeline, spec)});
  }
  // The cheapest change innermost; but a path's frames follow each other, and each turn ends before the next.
  std::stable_sort(loops.begin() + (spec.camera_path ? 1 : 0), loops.end(),
                   [](const Loop& a, const Loop& b) { return a.cost < b.cost; });
  return loops;
}

}  // namespace

std::vector<CellView> run_order(Pipeline& pipeline, const StudySpec& spec) {
  const std::vector<Loop> loops = make_loops(pipeline, spec);
  std::vector<CellView> order(cell_count(spec) * view_count(spec));
  std::vector<size_t> place(loops.size(), 0);
  for (CellView& item : order) {
    for (size_t i = 0; i < loops.size(); ++i) {
      item.cell += place[i] * loops[i].cell_stride;
      item.view += place[i] * loops[i].view_stride;
    }
    for (size_t i = 0; i < loops.size() && ++place[i] == loops[i].count; ++i) place[i] = 0;
  }
  return order;
}

}  // namespace inkbench
