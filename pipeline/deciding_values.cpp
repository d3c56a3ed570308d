// SPDX-License-Identifier: MIT
#include "pipeline/deciding_values.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace inkbench {
namespace {

/// What a shader's rounding may change of a small difference of large numbers; with more there is no telling.
constexpr double kLeastSlack = 1e-3, kMostSlack = 0.05;
/// Numbers so many times off draw or remove everything.
constexpr double kFarOff = 1000;

/// The pixel again and again with other values of one parameter.
class Retry {
 public:
  Retry(const EdgeDetector& detector, const PerBuffer<Image>& maps, const Settings& settings, int x, int y,
        double slack)
      : detector_(detector),
        maps_(maps),
        settings_(settings),
        x_(x),
        y_(y),
        slack_(slack),
        was_line_(is_line()) {}

  std::optional<ExplainedChange> change_of(const std::string& key) {
    const Param param = find_param(settings_, key, "explain");
    const Value now = param.value();
    std::optional<Value> value;
    if (std::holds_alternative<bool>(now)) value = switched(param, std::get<bool>(now));
    if (std::holds_alternative<float>(now)) value = nearest(param, std::get<float>(now));
    param.set(now, "explain");
    if (!value) return std::nullopt;
    return ExplainedChange{key, *value, now};
  }

 private:
  bool is_line() const { return detector_.explain(maps_, settings_, x_, y_).is_line; }

  bool changes_at(const Param& param, float value) {
    param.set(value, "explain");
    return is_line() != was_line_;
  }

  std::optional<Value> switched(const Param& param, bool now) {
    if (was_line_ || now) return std::nullopt;
    param.set(true, "explain");
    return is_line() ? std::optional<Value>(true) : std::nullopt;
  }

  /// A limit as a float, which may round out of the limits.
  static float within(const Field& field, double limit) {
    const auto value = static_cast<float>(limit);
    if (value < field.limits.low) return std::nextafter(value, std::numeric_limits<float>::max());
    return value > field.limits.high ? std::nextafter(value, 0.0F) : value;
  }

  std::optional<Value> nearest(const Param& param, float now) {
    for (const float far :
         {within(*param.field, param.field->limits.low), within(*param.field, param.field->limits.high)}) {
      if (far == now || !changes_at(param, far)) continue;
      const float value = rounded(param, boundary(param, now, far), far);
      const bool is_far_off =
          std::max(value, now) > kFarOff * std::min(value, now) && std::min(value, now) > 0;
      return is_far_off ? std::nullopt : std::optional<Value>(value);
    }
    return std::nullopt;
  }

  /// Of `kept`, where nothing changes, and `changed`, the value beside the other: halves the floats between
  /// them, which are in the order of their bits.
  float boundary(const Param& param, float kept, float changed) {
    auto from = std::bit_cast<int32_t>(kept), to = std::bit_cast<int32_t>(changed);
    while (std::abs(to - from) > 1) {
      const int32_t middle = from + (to - from) / 2;
      (changes_at(param, std::bit_cast<float>(middle)) ? to : from) = middle;
    }
    return std::bit_cast<float>(to);
  }

  /// To three digits away from the present value, and beyond the slack.
  float rounded(const Param& param, float value, float far) {
    const bool upwards = far > value;
    const double beyond = value * (upwards ? 1 + slack_ : 1 - slack_);
    const double unit = value > 0 ? std::pow(10.0, std::floor(std::log10(beyond)) - 2) : 1;
    const double text = (upwards ? std::ceil(beyond / unit) : std::floor(beyond / unit)) * unit;
    const auto result =
        static_cast<float>(upwards ? std::min<double>(text, far) : std::max<double>(text, far));
    return changes_at(param, result) ? result : value;
  }

  const EdgeDetector& detector_;
  const PerBuffer<Image>& maps_;
  Settings settings_;
  int x_, y_;
  double slack_;
  bool was_line_;
};

}  // namespace

std::vector<ExplainedChange> deciding_values(const EdgeDetector& detector, const PerBuffer<Image>& maps,
                                             const Settings& settings, int x, int y, double slack) {
  if (slack > kMostSlack) return {};
  Retry retry(detector, maps, settings, x, y, std::max(slack, kLeastSlack));
  std::vector<ExplainedChange> changes;
  for (const std::string& key : detector.deciding_parameters()) {
    if (const std::optional<ExplainedChange> change = retry.change_of(key)) changes.push_back(*change);
  }
  return changes;
}

}  // namespace inkbench
