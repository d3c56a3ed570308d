// SPDX-License-Identifier: MIT
#include "studies/tuning/search_space.h"

#include <algorithm>
#include <cmath>

#include "pipeline/base/text.h"

namespace inkbench {
namespace {

constexpr int kDigits = 4;

double rounded(double number) {
  if (number == 0 || !std::isfinite(number)) return number;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(number))) - (kDigits - 1));
  return std::round(number / unit) * unit;
}

double number_of(const Value& value) {
  if (const int* whole = std::get_if<int>(&value)) return *whole;
  return std::get<float>(value);
}

}  // namespace

Value value_at(const SearchAxis& axis, double share) {
  const double at = std::clamp(share, 0.0, 1.0);
  if (!axis.is_number()) {
    const auto count = static_cast<double>(axis.choices.size());
    return axis.choices[static_cast<size_t>(std::min(at * count, count - 1))];
  }
  const double number = axis.scale == Scale::log ? axis.from * std::pow(axis.to / axis.from, at)
                                                 : axis.from + (axis.to - axis.from) * at;
  if (axis.is_whole) return static_cast<int>(std::lround(std::clamp(number, axis.from, axis.to)));
  return static_cast<float>(std::clamp(rounded(number), axis.from, axis.to));
}

Values values_at(const SearchSpace& space, const Point& point) {
  Values values;
  for (size_t i = 0; i < space.size(); ++i) values.push_back(value_at(space[i], point[i]));
  return values;
}

double share_of(const SearchAxis& axis, const Value& value) {
  if (!axis.is_number()) {
    const auto found = std::find(axis.choices.begin(), axis.choices.end(), value);
    if (found == axis.choices.end()) return 0;
    return (static_cast<double>(found - axis.choices.begin()) + 0.5) /
           static_cast<double>(axis.choices.size());
  }
  if (axis.from == axis.to) return 0;
  const double number = std::clamp(number_of(value), axis.from, axis.to);
  if (axis.scale == Scale::log) return std::log(number / axis.from) / std::log(axis.to / axis.from);
  return (number - axis.from) / (axis.to - axis.from);
}

Point point_of(const SearchSpace& space, const Values& values) {
  Point point;
  for (size_t i = 0; i < space.size(); ++i) point.push_back(share_of(space[i], values[i]));
  return point;
}

Values values_of(const SearchSpace& space, const Settings& settings) {
  Values values;
  for (const SearchAxis& axis : space) values.push_back(find_param(settings, axis.key, axis.key).value());
  return values;
}

Settings with_values(const Settings& settings, const SearchSpace& space, const Values& values) {
  Settings changed = settings;
  for (size_t i = 0; i < space.size(); ++i)
    find_param(changed, space[i].key, space[i].key).set(values[i], space[i].key);
  return changed;
}

bool has_effect(const Settings& settings, const std::string& key) {
  const ConstParam param = find_param(settings, key, key);
  for (const ConstParamGroup& group : list_groups(settings)) {
    if (group.owner == param.owner) return matters(settings, group, *param.field);
  }
  return true;
}

std::string values_text(const SearchSpace& space, const Values& values) {
  std::vector<std::string> parts;
  for (size_t i = 0; i < space.size(); ++i) parts.push_back(space[i].key + " = " + to_text(values[i]));
  return join(parts, ", ");
}

}  // namespace inkbench
