// SPDX-License-Identifier: MIT
#include "studies/report/chart_axis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/report/chart_layout.h"
#include "studies/report/chart_text.h"
#include "studies/report/lettering.h"

namespace inkbench {
namespace {

constexpr double kMargin = 0.04;     // Of a horizontal axis, outside the values, on each side.
constexpr double kWorthZero = 0.45;  // Values from this share of their greatest up do not start at 0.
constexpr int kMaxTicks = 10;
constexpr int kMostDecades = 700;  // Of any log axis.
constexpr int kTurnedPx = 230;     // Longest turned label; longer ones are cut.
constexpr int kUprightPx = 260;    // Longest label beside a vertical axis.
constexpr int kUnlimitedPx = 1'000'000;
constexpr double kTurnedRadians = kTurnedDegrees * std::numbers::pi / 180;
constexpr double kRounding = 1e-9;  // Of a step.

/// Enough space between numbers in different steps: the widths of labels and of the gap between them.
struct Spacing {
  bool along = false;  ///< Labels stand beside each other, not above each other.
  int size_px = 0;
  bool is_whole = false;

  double room_px(const ChartTick& tick) const {
    return along ? text_width_px(tick.label, size_px, Face::regular) + size_px : 1.9 * size_px;
  }
};

bool fits(const ChartAxis& axis, const std::vector<ChartTick>& ticks, int length_px, const Spacing& spacing) {
  if (std::ssize(ticks) > kMaxTicks) return false;
  for (size_t i = 1; i < ticks.size(); ++i) {
    const double distance = (axis.part(ticks[i].at) - axis.part(ticks[i - 1].at)) * length_px;
    if (distance < (spacing.room_px(ticks[i - 1]) + spacing.room_px(ticks[i])) / 2) return false;
  }
  return true;
}

/// 1, 2 or 5 times a power of ten: the `index`th such number from 1 on, or below it where negative.
double round_step(int index) {
  static constexpr double kFactors[] = {1, 2, 5};
  const int decade = index >= 0 ? index / 3 : -((2 - index) / 3);
  return kFactors[index - 3 * decade] * std::pow(10.0, decade);
}

/// The index of the largest round step that is not above `size`.
int step_index(double size) {
  int index = 3 * static_cast<int>(std::floor(std::log10(size)));
  while (round_step(index + 1) <= size * (1 + kRounding)) ++index;
  return index;
}

int decimals_of_step(double step) {
  return std::clamp(static_cast<int>(-std::floor(std::log10(step) + kRounding)), 0, 12);
}

std::vector<ChartTick> linear_ticks(double low, double high, double step) {
  std::vector<ChartTick> ticks;
  const double first = std::ceil(low / step - kRounding);
  const int count = static_cast<int>(std::min(std::floor((high - first * step) / step + kRounding), 99.0));
  for (int i = 0; i <= count; ++i) {
    const double at = (first + i) * step;
    ticks.push_back({at == 0 ? 0 : at, readable_number(at, decimals_of_step(step))});
  }
  return ticks;
}

void set_linear_ticks(ChartAxis& axis, int length_px, const Spacing& spacing) {
  const int first = step_index((axis.high - axis.low) / kMaxTicks);
  for (int index = spacing.is_whole ? std::max(first, 0) : first;; ++index) {
    axis.ticks = linear_ticks(axis.low, axis.high, round_step(index));
    if (fits(axis, axis.ticks, length_px, spacing)) break;
  }
}

bool is_within(const ChartAxis& axis, double value) {
  return value >= axis.low * (1 - kRounding) && value <= axis.high * (1 + kRounding);
}

/// Multiples by `factors` of each `stride`th power of ten.
std::vector<double> log_places(const ChartAxis& axis, const std::vector<double>& factors, int stride) {
  std::vector<double> places;
  const int last = static_cast<int>(std::ceil(std::log10(axis.high)));
  for (int decade = static_cast<int>(std::floor(std::log10(axis.low))); decade <= last; ++decade) {
    if (decade % stride != 0) continue;
    for (const double factor : factors) {
      const double at = factor * std::pow(10.0, decade);
      if (is_within(axis, at)) places.push_back(at);
    }
  }
  return places;
}

/// Sets of ticks from dense to sparse: multiples of powers of ten, then only each so many of these.
std::vector<double> log_tick_set(const ChartAxis& axis, int sparseness) {
  switch (sparseness) {
    case 0:
      return log_places(axis, {1, 2, 5}, 1);
    case 1:
      return log_places(axis, {1, 3}, 1);
    default:
      return log_places(axis, {1}, sparseness - 1);
  }
}

void set_log_ticks(ChartAxis& axis, int length_px, const Spacing& spacing) {
  for (int sparseness = 0; sparseness < kMostDecades; ++sparseness) {
    axis.ticks.clear();
    for (const double at : log_tick_set(axis, sparseness)) axis.ticks.push_back({at, readable_number(at)});
    if (fits(axis, axis.ticks, length_px, spacing)) break;
  }
  const double decades = std::log10(axis.high / axis.low);
  if (axis.ticks.size() < 2 || (axis.ticks.size() == 2 && decades < 1))
    return set_linear_ticks(axis, length_px, spacing);
  if (decades > 6) return;
  for (const double at : log_places(axis, {1, 2, 3, 4, 5, 6, 7, 8, 9}, 1)) {
    const bool is_labelled = std::any_of(axis.ticks.begin(), axis.ticks.end(), [&](const ChartTick& tick) {
      return std::abs(tick.at - at) < kRounding * at;
    });
    if (!is_labelled) axis.minor.push_back(at);
  }
}

void set_ticks(ChartAxis& axis, int length_px, const Spacing& spacing) {
  axis.is_log ? set_log_ticks(axis, length_px, spacing) : set_linear_ticks(axis, length_px, spacing);
}

/// A range with some width around a single value.
void widen(ChartAxis& axis, const AxisNeeds& needs) {
  if (axis.high - axis.low > kRounding * std::max(std::abs(axis.low), std::abs(axis.high))) return;
  const double step = axis.low == 0 ? 1 : std::abs(axis.low) * 0.1;
  if (!needs.from) axis.low = axis.is_log ? axis.low / 1.5 : axis.low - step;
  if (!needs.to) axis.high = axis.is_log ? axis.high * 1.5 : axis.high + step;
}

/// Adds what stands apart: its own tick, the break, and no other tick in its way.
void set_apart(ChartAxis& axis, const AxisNeeds& needs) {
  const ChartTick& apart = *needs.apart;
  const bool is_above = apart.at > needs.high;
  axis.break_at = std::sqrt(apart.at * (is_above ? needs.high : needs.low));
  const auto is_beyond = [&](double at) { return (at > *axis.break_at) == is_above; };
  std::erase_if(axis.minor, is_beyond);
  const Spacing spacing{true, needs.size_px};
  std::erase_if(axis.ticks, [&](const ChartTick& tick) {
    const double distance = std::abs(axis.part(tick.at) - axis.part(apart.at)) * needs.length_px;
    const bool is_near = distance < (spacing.room_px(tick) + spacing.room_px(apart)) / 2;
    if (is_near && !is_beyond(tick.at)) axis.minor.push_back(tick.at);
    return is_near || is_beyond(tick.at);
  });
  axis.ticks.push_back(apart);
}

/// Moves the ends that were not asked for to ticks.
void round_ends(ChartAxis& axis, const AxisNeeds& needs) {
  if (axis.is_log) {
    const bool by_decades = std::log10(axis.high / axis.low) > 2;
    const auto below = [&](double v) {
      return by_decades ? std::pow(10.0, std::floor(std::log10(v) + kRounding)) : round_step(step_index(v));
    };
    const double top = below(axis.high);
    if (!needs.from) axis.low = below(axis.low);
    if (!needs.to && axis.high > top * (1 + kRounding))
      axis.high = by_decades ? top * 10 : round_step(step_index(axis.high) + 1);
    return;
  }
  const double wanted_ticks = std::clamp(needs.length_px / (2.6 * needs.size_px), 2.0, kMaxTicks - 1.0);
  const double step = round_step(step_index((axis.high - axis.low) / wanted_ticks * (1 - kRounding)) + 1);
  if (!needs.from) axis.low = std::floor(axis.low / step + kRounding) * step;
  if (!needs.to) axis.high = std::ceil(axis.high / step - kRounding) * step;
}

ChartAxis start(const AxisNeeds& needs) {
  ChartAxis axis;
  axis.is_log = needs.scale == Scale::log;
  axis.low = needs.from.value_or(needs.low);
  axis.high = needs.to.value_or(needs.high);
  // An end that was asked for may lie beyond all values.
  if (axis.high < axis.low) (needs.to ? axis.low : axis.high) = needs.to ? axis.high : axis.low;
  return axis;
}

ChartAxis categories(size_t count) {
  ChartAxis axis;
  axis.low = 0.5;
  axis.high = static_cast<double>(count) + 0.5;
  return axis;
}

int widest_px(const std::vector<std::string>& labels, int size_px) {
  int widest = 0;
  for (const std::string& label : labels)
    widest = std::max(widest, text_width_px(label, size_px, Face::regular));
  return widest;
}

/// Labels every so many categories that each has `needed_px`.
void add_each(ChartAxis& axis, const std::vector<std::string>& labels, double slot_px, double needed_px,
              int limit_px, int size_px) {
  const auto stride = static_cast<size_t>(std::max(1.0, std::ceil(needed_px / slot_px)));
  for (size_t i = 0; i < labels.size(); i += stride)
    axis.ticks.push_back({static_cast<double>(i) + 1, shortened(labels[i], limit_px, size_px)});
}

}  // namespace

double ChartAxis::part(double value) const {
  return is_log ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

ChartAxis horizontal_axis(const AxisNeeds& needs) {
  ChartAxis axis = start(needs);
  if (needs.apart) {
    axis.low = std::min(axis.low, needs.apart->at);
    axis.high = std::max(axis.high, needs.apart->at);
  }
  widen(axis, needs);
  if (axis.is_log) {
    const double factor = std::pow(axis.high / axis.low, kMargin);
    axis.low /= factor;
    axis.high *= factor;
  } else {
    const double margin = (axis.high - axis.low) * kMargin;
    axis.low -= margin;
    axis.high += margin;
  }
  set_ticks(axis, needs.length_px, {true, needs.size_px, needs.is_whole});
  if (needs.apart) set_apart(axis, needs);
  axis.labels_px = needs.size_px;
  return axis;
}

ChartAxis vertical_axis(const AxisNeeds& needs) {
  ChartAxis axis = start(needs);
  if (!axis.is_log && !needs.from && axis.low > 0 && axis.low < kWorthZero * axis.high) axis.low = 0;
  widen(axis, needs);
  round_ends(axis, needs);
  set_ticks(axis, needs.length_px, {false, needs.size_px});
  return axis;
}

ChartAxis category_axis(const std::vector<std::string>& labels, bool are_names, int length_px, int size_px) {
  ChartAxis axis = categories(labels.size());
  const double slot_px = static_cast<double>(length_px) / static_cast<double>(labels.size());
  const int widest = widest_px(labels, size_px);
  axis.labels_px = size_px;
  axis.is_turned = are_names && widest > slot_px - size_px / 2.0;
  const double needed_px = axis.is_turned ? 1.25 * size_px : are_names ? 0 : widest + size_px / 2.0;
  add_each(axis, labels, slot_px, needed_px, axis.is_turned ? kTurnedPx : kUnlimitedPx, size_px);
  if (axis.is_turned) {
    const double across =
        std::min(widest, kTurnedPx) * std::sin(kTurnedRadians) + size_px * std::cos(kTurnedRadians);
    axis.labels_px = static_cast<int>(across);
  }
  return axis;
}

ChartAxis upright_category_axis(const std::vector<std::string>& labels, int length_px, int size_px) {
  ChartAxis axis = categories(labels.size());
  const double slot_px = static_cast<double>(length_px) / static_cast<double>(labels.size());
  add_each(axis, labels, slot_px, 1.25 * size_px, kUprightPx, size_px);
  return axis;
}

ChartAxis scale_axis(const AxisNeeds& needs) {
  ChartAxis axis = start(needs);
  widen(axis, needs);
  set_ticks(axis, needs.length_px, {false, needs.size_px});
  return axis;
}

int decimals_for(double low, double high, int steps) {
  if (low < high) return decimals_of_step((high - low) / steps);
  return low == 0 ? 0 : decimals_of_step(std::abs(low) / 100);
}

}  // namespace inkbench
