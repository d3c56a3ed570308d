#include <algorithm>
#include <numeric>

#include "studies/sweep/run_study.h"

namespace inkbench {
namespace {

/// What a change costs, by the stages whose keys differ. The weights are the passes' rough shares of a frame;
/// only their order matters.
int change_cost(const PassKeys& a, const PassKeys& b) {
  int cost = 0;
  cost += a.meshes != b.meshes ? 200 : 0;
  cost += a.gbuffer != b.gbuffer ? 10 : 0;
  cost += a.gradient != b.gradient ? 10 : 0;
  cost += a.range != b.range ? 5 : 0;
  cost += a.shade != b.shade ? 8 : 0;
  cost += a.combine != b.combine ? 2 : 0;
  cost += a.ink != b.ink ? 1 : 0;
  return cost;
}

int axis_cost(Pipeline& pipeline, const StudySpec& spec, const Axis& axis) {
  const auto keys_at = [&](const Value& value) {
    Settings settings = spec.base;
    find_param(settings, axis.key, axis.key).set(value, axis.key);
    return pipeline.keys(settings);
  };
  return change_cost(keys_at(axis.values.front()), keys_at(axis.values.back()));
}

}  // namespace

std::vector<size_t> run_order(Pipeline& pipeline, const StudySpec& spec) {
  std::vector<size_t> order(cell_count(spec));
  std::iota(order.begin(), order.end(), size_t{0});
  if (spec.axes.size() < 2) return order;

  std::vector<size_t> axes(spec.axes.size());
  std::iota(axes.begin(), axes.end(), size_t{0});
  std::vector<int> costs;
  for (const Axis& axis : spec.axes) costs.push_back(axis_cost(pipeline, spec, axis));
  // Costliest first; equal ones as the grid has them, pages outermost.
  std::stable_sort(axes.begin(), axes.end(),
                   [&](size_t a, size_t b) { return costs[a] != costs[b] ? costs[a] > costs[b] : a > b; });

  size_t position = 0;
  std::vector<size_t> strides{1};
  for (const Axis& axis : spec.axes) strides.push_back(strides.back() * axis.values.size());
  std::vector<size_t> place(spec.axes.size(), 0);
  for (; position < order.size(); ++position) {
    order[position] = 0;
    for (size_t i = 0; i < place.size(); ++i) order[position] += place[i] * strides[i];
    for (size_t i = axes.size(); i-- > 0;) {  // count up, the cheapest axis fastest
      if (++place[axes[i]] < spec.axes[axes[i]].values.size()) break;
      place[axes[i]] = 0;
    }
  }
  return order;
}

}  // namespace inkbench
