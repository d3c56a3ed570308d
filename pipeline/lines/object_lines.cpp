// SPDX-License-Identifier: MIT
#include "pipeline/lines/object_lines.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "pipeline/lines/visibility.h"

namespace inkbench {
namespace {

/// A unit step from pixel corner to pixel corner, the larger id on its left (y down).
struct Step {
  int x = 0, y = 0;
  int direction = 0;  ///< 0 right, 1 up, 2 left, 3 down: one more is a left turn.
  float left_depth = 0.0F, right_depth = 0.0F;
};

constexpr int kDx[] = {1, 0, -1, 0};
constexpr int kDy[] = {0, -1, 0, 1};

/// All steps between one pair of ids, joined.
class PairTracer {
 public:
  explicit PairTracer(std::vector<Step> steps) : steps_(std::move(steps)), done_(steps_.size(), false) {
    for (size_t i = 0; i < steps_.size(); ++i) starting_at_[corner(steps_[i].x, steps_[i].y)].push_back(i);
    for (const Step& step : steps_)
      ++ending_at_[corner(step.x + kDx[step.direction], step.y + kDy[step.direction])];
  }

  /// `smaller`, `larger`: the ids, of which the nearer one goes into the lines.
  void trace(int smaller, int larger, std::vector<Polyline>& lines) {
    for (size_t i = 0; i < steps_.size(); ++i) {
      const auto incoming = ending_at_.find(corner(steps_[i].x, steps_[i].y));
      if (!done_[i] && incoming == ending_at_.end()) add_line(i, smaller, larger, lines);
    }
    for (size_t i = 0; i < steps_.size(); ++i) {
      if (!done_[i]) add_line(i, smaller, larger, lines);
    }
  }

 private:
  static int64_t corner(int x, int y) { return (static_cast<int64_t>(y) << 32) | x; }

  /// The step that goes on from the end of another, the leftmost turn first; itself if none does.
  size_t next_of(size_t current) const {
    const Step& step = steps_[current];
    const auto found = starting_at_.find(corner(step.x + kDx[step.direction], step.y + kDy[step.direction]));
    if (found == starting_at_.end()) return current;
    for (const int turn : {1, 0, 3}) {
      for (const size_t i : found->second) {
        if (!done_[i] && steps_[i].direction == (step.direction + turn) % 4) return i;
      }
    }
    return current;
  }

  void add_line(size_t first, int smaller, int larger, std::vector<Polyline>& lines) {
    Polyline line{LineClass::object, 0, {{steps_[first].x, steps_[first].y}}};
    double left_depth = 0.0;
    double right_depth = 0.0;
    int length_px = 0;
    int direction = -1;
    for (size_t i = first, last = steps_.size(); i != last; ++length_px) {
      const Step& step = steps_[i];
      done_[i] = true;
      left_depth += step.left_depth;
      right_depth += step.right_depth;
      const glm::vec2 end(step.x + kDx[step.direction], step.y + kDy[step.direction]);
      if (step.direction == direction) {
        line.points.back() = end;
      } else {
        line.points.push_back(end);
      }
      direction = step.direction;
      last = i;
      i = next_of(i);
    }
    line.object_id = left_depth <= right_depth ? larger : smaller;
    if (length_px >= kShortestPiecePx) lines.push_back(std::move(line));
  }

  std::vector<Step> steps_;
  std::vector<bool> done_;
  std::unordered_map<int64_t, std::vector<size_t>> starting_at_;
  std::unordered_map<int64_t, int> ending_at_;
};

using StepsByPair = std::map<std::pair<int, int>, std::vector<Step>>;

StepsByPair find_steps(const Image& object_id, const Image& depth) {
  StepsByPair steps;
  // The larger id must lie on the left: upwards that is the left pixel, to the right the upper one.
  const auto add = [&](const Step& larger_first, const Step& smaller_first, size_t first, size_t second) {
    const auto id = static_cast<int>(std::lround(object_id.samples[first]));
    const auto other = static_cast<int>(std::lround(object_id.samples[second]));
    Step step = id > other ? larger_first : smaller_first;
    step.left_depth = depth.samples[id > other ? first : second];
    step.right_depth = depth.samples[id > other ? second : first];
    if (id != other) steps[std::minmax({id, other})].push_back(step);
  };
  for (int y = 0; y < object_id.height_px; ++y) {
    for (int x = 0; x < object_id.width_px; ++x) {
      const size_t here = object_id.index(x, y);
      const size_t right = here + 1;
      const size_t below = here + static_cast<size_t>(object_id.width_px);
      if (x + 1 < object_id.width_px && object_id.samples[here] != object_id.samples[right])
        add({x + 1, y + 1, 1}, {x + 1, y, 3}, here, right);
      if (y + 1 < object_id.height_px && object_id.samples[here] != object_id.samples[below])
        add({x, y + 1, 0}, {x + 1, y + 1, 2}, here, below);
    }
  }
  return steps;
}

}  // namespace

std::vector<Polyline> object_lines(const Image& object_id, const Image& depth) {
  assert(object_id.width_px == depth.width_px && object_id.height_px == depth.height_px);
  std::vector<Polyline> lines;
  for (auto& [pair, steps] : find_steps(object_id, depth))
    PairTracer(std::move(steps)).trace(pair.first, pair.second, lines);
  return lines;
}

}  // namespace inkbench
