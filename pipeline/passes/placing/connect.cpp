// SPDX-License-Identifier: MIT
#include "pipeline/passes/placing/connect.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "pipeline/flow/describe_pass.h"
#include "pipeline/lines/line_map.h"
#include "pipeline/passes/placing/placed_lines.h"

namespace inkbench {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// Pixels of lines as a graph: each with its linked neighbours.
class LineGraph {
 public:
  explicit LineGraph(const Image& placed) : placed_(placed) {}

  bool is_line(int x, int y) const {
    return x >= 0 && y >= 0 && x < placed_.width_px && y < placed_.height_px && placed_.at(x, y, 2) > 0.0F;
  }
  /// Calls `visit(x, y, length)`: beside it, and across a corner where neither pixel beside both is a line.
  template <class Visit>
  void visit_neighbours(int x, int y, const Visit& visit) const {
    for (int i = 0; i < 9; ++i) {
      const int dx = i % 3 - 1, dy = i / 3 - 1;
      if ((dx == 0 && dy == 0) || !is_line(x + dx, y + dy)) continue;
      const bool diagonal = dx != 0 && dy != 0;
      if (diagonal && (is_line(x + dx, y) || is_line(x, y + dy))) continue;
      visit(x + dx, y + dy, diagonal ? std::sqrt(2.0F) : 1.0F);
    }
  }
  bool is_end(int x, int y) const {
    int neighbours = 0;
    visit_neighbours(x, y, [&](int, int, float) { ++neighbours; });
    return neighbours <= 1;
  }

 private:
  const Image& placed_;
};

struct LinePart {
  std::vector<Pixel> pixels;
  float strongest = 0;
};

LinePart part_from(const LineGraph& graph, const Image& placed, Pixel start, LineMap& seen) {
  LinePart part{{start}};
  seen.set(start.x, start.y);
  for (size_t i = 0; i < part.pixels.size(); ++i) {
    const Pixel at = part.pixels[i];
    part.strongest = std::max(part.strongest, placed.at(at.x, at.y, 3));
    graph.visit_neighbours(at.x, at.y, [&](int x, int y, float) {
      if (seen.at(x, y)) return;
      seen.set(x, y);
      part.pixels.push_back({x, y});
    });
  }
  return part;
}

/// Lengths of the shortest ways from the nearest of `starts`, in a map of all pixels that the caller resets.
void spread(const LineGraph& graph, const std::vector<Pixel>& starts, Image& distance) {
  using Reached = std::pair<float, std::pair<int, int>>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
  for (const Pixel& start : starts) {
    distance.at(start.x, start.y) = 0;
    front.push({0.0F, {start.x, start.y}});
  }
  while (!front.empty()) {
    const float length = front.top().first;  // no structured binding: clang 14 lets no lambda see one
    const std::pair<int, int> at = front.top().second;
    front.pop();
    if (length > distance.at(at.first, at.second)) continue;
    graph.visit_neighbours(at.first, at.second, [&](int x, int y, float step) {
      if (length + step >= distance.at(x, y)) return;
      distance.at(x, y) = length + step;
      front.push({length + step, {x, y}});
    });
  }
}

void reset(const LinePart& part, Image& distance) {
  for (const Pixel& pixel : part.pixels) distance.at(pixel.x, pixel.y) = kFar;
}

/// All steps between linked pixels; a line with ends is a pixel longer.
float length_of(const LineGraph& graph, const LinePart& part) {
  float steps = 0;
  bool has_end = false;
  for (const Pixel& pixel : part.pixels) {
    graph.visit_neighbours(pixel.x, pixel.y, [&](int, int, float step) { steps += 0.5F * step; });
    has_end = has_end || graph.is_end(pixel.x, pixel.y);
  }
  return steps + (has_end ? 1.0F : 0.0F);
}

void set_widths(const LineGraph& graph, const LinePart& part, float taper_px, Image& distance,
                Image& placed) {
  std::vector<Pixel> ends;
  for (const Pixel& pixel : part.pixels) {
    if (graph.is_end(pixel.x, pixel.y)) ends.push_back(pixel);
  }
  const bool tapers = taper_px > 0 && !ends.empty();
  if (tapers) spread(graph, ends, distance);
  for (const Pixel& pixel : part.pixels) {
    const float from_end = tapers ? distance.at(pixel.x, pixel.y) + 0.5F : kFar;
    placed.at(pixel.x, pixel.y, 3) = tapers ? std::min(from_end / taper_px, 1.0F) : 1.0F;
  }
  reset(part, distance);
}

ConnectParams params_of(const Settings& settings) {
  return {settings.edges.weak < 1.0F, settings.edges.min_length, settings.line.taper};
}

struct ConnectInput {
  ConnectInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() {
    return {{EdgesParams::description().group}, {LineParams::description().group}};
  }
  ConnectParams get(const FrameState& frame) const { return params_of(frame.settings); }
  void fold(KeyBuilder& key, const FrameState& frame) const {
    const ConnectParams params = get(frame);
    for (const float value : {params.has_weak ? 1.0F : 0.0F, params.min_length_px, params.taper_px})
      key.add_bytes({reinterpret_cast<const uint8_t*>(&value), sizeof value});
  }
};

}  // namespace

Image connected(Image placed, const ConnectParams& params) {
  const Image before = placed;
  const LineGraph graph(before);
  LineMap seen(placed.width_px, placed.height_px);
  Image distance(placed.width_px, placed.height_px, 1, kFar);
  for (int y = 0; y < placed.height_px; ++y) {
    for (int x = 0; x < placed.width_px; ++x) {
      if (!graph.is_line(x, y) || seen.at(x, y)) continue;
      const LinePart part = part_from(graph, before, {x, y}, seen);
      const bool is_weak = params.has_weak && part.strongest < 1.0F;
      if (is_weak || length_of(graph, part) < params.min_length_px) {
        for (const Pixel& pixel : part.pixels) set_placed(placed, pixel.x, pixel.y, {});
      } else {
        set_widths(graph, part, params.taper_px, distance, placed);
      }
    }
  }
  return placed;
}

const PassKind& ConnectPass::kind() {
  static const PassKind kKind =
      describe_pass<ConnectPass>("connect", 6, {}, value_of<PlacedLines>(), ConnectInput{});
  return kKind;
}

bool ConnectPass::hands_on(const Settings& settings) {
  const ConnectParams params = params_of(settings);
  return !params.has_weak && params.min_length_px <= 0 && params.taper_px <= 0;
}

Texture ConnectPass::run(const Texture& placed, const ConnectParams& params) const {
  Texture result("connected lines", TextureFormat::rgba8, placed.width_px(), placed.height_px());
  result.upload(connected(placed.read(0, 4), params));
  return result;
}

}  // namespace inkbench
