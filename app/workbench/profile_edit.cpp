// SPDX-License-Identifier: MIT
#include "app/workbench/profile_edit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace inkbench {
namespace {

/// Beyond what was drawn the profile keeps its course from here on.
constexpr float kBlend = 0.02F;

float rounded(float share) {
  return std::round(std::clamp(share, 0.0F, 1.0F) * 1000.0F) / 1000.0F;
}

ProfilePoint rounded(const ProfilePoint& point) {
  return {rounded(point.along), rounded(point.share)};
}

bool is_before(const ProfilePoint& a, const ProfilePoint& b) {
  return a.along < b.along;
}

float between(const ProfilePoint& a, const ProfilePoint& b, float along) {
  if (b.along <= a.along) return b.share;
  return a.share + (b.share - a.share) * (along - a.along) / (b.along - a.along);
}

/// The line as a course of rising places: where the hand went back, what it drew before is gone.
WidthProfile rising(std::span<const ProfilePoint> drawn) {
  if (drawn.empty()) return {};
  WidthProfile line{drawn.front()};
  for (size_t i = 1; i < drawn.size(); ++i) {
    const float low = std::min(drawn[i - 1].along, drawn[i].along);
    const float high = std::max(drawn[i - 1].along, drawn[i].along);
    std::erase_if(line, [&](const ProfilePoint& point) { return point.along >= low && point.along <= high; });
    if (high > low) line.push_back(drawn[i - 1]);
    line.push_back(drawn[i]);
    std::sort(line.begin(), line.end(), is_before);
  }
  return line;
}

/// Douglas and Peucker's way, by the difference of shares. Adds what lies between `first` and `last` and is
/// needed.
void add_needed(const WidthProfile& line, size_t first, size_t last, float tolerance, WidthProfile& kept) {
  size_t farthest = first;
  float most = tolerance;
  for (size_t i = first + 1; i < last; ++i) {
    const float off = std::abs(line[i].share - between(line[first], line[last], line[i].along));
    if (off <= most) continue;
    most = off;
    farthest = i;
  }
  if (farthest == first) return;
  add_needed(line, first, farthest, tolerance, kept);
  kept.push_back(line[farthest]);
  add_needed(line, farthest, last, tolerance, kept);
}

WidthProfile simplified(const WidthProfile& line, float tolerance) {
  if (line.size() < 3) return line;
  WidthProfile kept{line.front()};
  add_needed(line, 0, line.size() - 1, tolerance, kept);
  kept.push_back(line.back());
  return kept;
}

}  // namespace

WidthProfile with_point(const WidthProfile& profile, const ProfilePoint& point) {
  const ProfilePoint added = rounded(point);
  WidthProfile next = profile;
  std::erase_if(next, [&](const ProfilePoint& other) { return other.along == added.along; });
  next.insert(std::upper_bound(next.begin(), next.end(), added, is_before), added);
  return next;
}

WidthProfile move_point(const WidthProfile& profile, size_t index, const ProfilePoint& to) {
  WidthProfile next = profile;
  const float low = index > 0 ? profile[index - 1].along : 0.0F;
  const float high = index + 1 < profile.size() ? profile[index + 1].along : 1.0F;
  next[index] = rounded({std::clamp(to.along, low, high), to.share});
  return next;
}

WidthProfile remove_point(const WidthProfile& profile, size_t index) {
  WidthProfile next = profile;
  next.erase(next.begin() + static_cast<std::ptrdiff_t>(index));
  return next;
}

WidthProfile drawn_over(const WidthProfile& profile, std::span<const ProfilePoint> drawn, float tolerance) {
  const WidthProfile line = rising(drawn);
  if (line.size() < 2) return profile;
  const float low = line.front().along - kBlend, high = line.back().along + kBlend;
  WidthProfile next;
  for (const ProfilePoint& point : profile) {
    if (point.along < low) next.push_back(point);
  }
  if (low > 0.0F) next.push_back({low, share_of(profile, low)});
  for (const ProfilePoint& point : simplified(line, tolerance)) next.push_back(point);
  if (high < 1.0F) next.push_back({high, share_of(profile, high)});
  for (const ProfilePoint& point : profile) {
    if (point.along > high) next.push_back(point);
  }
  std::transform(next.begin(), next.end(), next.begin(),
                 [](const ProfilePoint& point) { return rounded(point); });
  return next;
}

}  // namespace inkbench
