// SPDX-License-Identifier: MIT
#include "pipeline/curves/covering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "pipeline/base/parallel.h"

namespace inkbench {
namespace {

constexpr size_t kMostRays = 9;
constexpr double kPxPerRay = 6.0;
/// One ray is enough for what is shorter.
constexpr double kOneRayPx = 2.0;
/// What is shorter takes what its neighbour has: nobody sees it, and a ray so near to a crossing may run
/// through an edge.
constexpr double kUnseenPx = 0.5;
/// How far beside an outline one looks for what lies behind it.
constexpr double kBesidePx = 1.0;

Ray in_mesh(const Ray& ray, const CurveModel& model) {
  return {glm::dvec3(model.to_mesh * glm::dvec4(ray.origin, 1.0)), glm::dmat3(model.to_mesh) * ray.direction,
          ray.from, ray.to};
}

double step_px(const LinePoint& a, const LinePoint& b) {
  return std::hypot(b.pixel.x - a.pixel.x, b.pixel.y - a.pixel.y);
}

/// A place on a step of a line.
struct Sample {
  uint32_t step = 0;
  glm::dvec3 world{0.0}, pixel{0.0};
};

Sample sample_on(const ViewLine& line, uint32_t step, double along) {
  const LinePoint& a = line.points[step];
  const LinePoint& b = line.points[step + 1];
  Sample sample{step, {}, glm::mix(a.pixel, b.pixel, along)};
  sample.world = glm::mix(a.world, b.world, along_in_world(a, b, along));
  return sample;
}

/// A few of them, which take no memory of their own.
struct Samples {
  std::array<Sample, kMostRays> list;
  size_t count = 0;
};

/// In the middles of equal shares of the part's length.
Samples samples_of(const ViewEdge& edge, const ViewLine& line) {
  const auto wanted = static_cast<size_t>(edge.length_px / kPxPerRay);
  const size_t count = edge.length_px < kOneRayPx ? 1 : std::clamp<size_t>(wanted | 1U, 3, kMostRays);
  Samples samples;
  double before = 0.0;
  uint32_t step = edge.from;
  for (size_t i = 0; i < count; ++i) {
    const double at = edge.length_px * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    double length = step_px(line.points[step], line.points[step + 1]);
    while (step + 1 < edge.to && before + length < at) {
      before += length;
      ++step;
      length = step_px(line.points[step], line.points[step + 1]);
    }
    samples.list[samples.count++] =
        sample_on(line, step, length > 0.0 ? std::min((at - before) / length, 1.0) : 0.5);
  }
  return samples;
}

/// The side of a step on which the surfaces lie that end there: 1 on the right as seen along it, -1, or 0
/// where it cannot be told.
double side_of_surface(const ViewLine& line, uint32_t step, const Covering& covering) {
  const uint32_t edge = line.steps[step].edge;
  if (edge == LineStep::kNone) return 0.0;
  const CurveModel& model = covering.models()[static_cast<size_t>(line.model)];
  const MeshTopology& topology = model.source->topology();
  const auto uses = topology.uses_of(topology.edges[edge]);
  for (const uint32_t corner : topology.faces[uses[0].face]) {
    const auto& ends = topology.edges[edge].points;
    if (corner == ends[0] || corner == ends[1]) continue;
    const glm::dvec4 clip =
        covering.view().to_clip(glm::dvec3(model.to_world * glm::dvec4(topology.positions[corner], 1.0)));
    if (!(clip.w > 0.0)) return 0.0;
    const glm::dvec3 pixel = covering.view().to_pixel(clip);
    const glm::dvec3& a = line.points[step].pixel;
    const glm::dvec3& b = line.points[step + 1].pixel;
    const double turn = (b.x - a.x) * (pixel.y - a.y) - (b.y - a.y) * (pixel.x - a.x);
    return turn > 0.0 ? 1.0 : turn < 0.0 ? -1.0 : 0.0;
  }
  return 0.0;
}

Behind behind_at(const Sample& sample, const ViewLine& line, const Covering& covering) {
  const double side = side_of_surface(line, sample.step, covering);
  const glm::dvec2 along(line.points[sample.step + 1].pixel - line.points[sample.step].pixel);
  const double length = glm::length(along);
  if (side == 0.0 || !(length > 0.0)) return Behind::unknown;
  const glm::dvec2 right(-along.y / length, along.x / length);
  const int object =
      covering.object_behind(glm::dvec2(sample.pixel) - kBesidePx * side * right, sample.pixel.z);
  const int own = covering.models()[static_cast<size_t>(line.model)].object_id;
  return object == 0 ? Behind::nothing : object == own ? Behind::same_object : Behind::other_object;
}

struct Vote {
  int median = 0;
  bool is_majority = false;
};

/// Asks `ask(i)` in order, until more than half of `count`, at most `kMostRays`, say the same: the median of
/// all is that.
template <class Ask>
Vote vote(size_t count, const Ask& ask) {
  std::array<int, kMostRays> votes{};
  for (size_t i = 0; i < count; ++i) {
    votes[i] = ask(i);
    const auto same = std::count(votes.data(), votes.data() + i + 1, votes[i]);
    if (2 * static_cast<size_t>(same) > count) return {votes[i], true};
  }
  std::sort(votes.data(), votes.data() + count);
  return {votes[count / 2], false};
}

void decide(ViewEdge& edge, const ViewLine& line, const Covering& covering) {
  const Samples samples = samples_of(edge, line);
  const Vote covered =
      vote(samples.count, [&](size_t i) { return covering.surfaces_before(samples.list[i].world); });
  edge.covered = covered.median;
  edge.is_doubtful = !covered.is_majority;
  if (edge.covered > 0 || !line.covers) return;
  const std::array<size_t, 3> places{samples.count / 2, 0, samples.count - 1};
  const Vote behind = vote(std::min(samples.count, places.size()), [&](size_t i) {
    return static_cast<int>(behind_at(samples.list[places[i]], line, covering));
  });
  edge.behind = static_cast<Behind>(behind.median);
}

/// The parts that rays are sent to: of neighbours that are too short to see one in every `kUnseenPx`, and one
/// of every line.
std::vector<uint32_t> asked_edges(std::span<const ViewEdge> edges, const std::vector<ViewLine>& lines) {
  std::vector<uint32_t> asked;
  double unasked_px = 0.0;
  for (uint32_t i = 0; i < edges.size(); ++i) {
    if (lines[edges[i].line].follows) continue;
    const bool is_first = i == 0 || edges[i - 1].line != edges[i].line;
    if (is_first) unasked_px = 0.0;
    unasked_px += edges[i].length_px;
    const bool is_last = i + 1 == edges.size() || edges[i + 1].line != edges[i].line;
    const bool none_yet = asked.empty() || edges[asked.back()].line != edges[i].line;
    if (unasked_px < kUnseenPx && !(is_last && none_yet)) continue;
    asked.push_back(i);
    unasked_px = 0.0;
  }
  return asked;
}

void start_at_change(ViewLine& line) {
  if (!line.is_closed || line.points[0].change) return;
  const auto change = std::find_if(line.points.begin(), line.points.end(),
                                   [](const LinePoint& point) { return point.change.has_value(); });
  if (change == line.points.end()) return;
  const auto shift = change - line.points.begin();
  line.points.pop_back();
  std::rotate(line.points.begin(), line.points.begin() + shift, line.points.end());
  line.points.push_back(line.points.front());
  std::rotate(line.steps.begin(), line.steps.begin() + shift, line.steps.end());
}

}  // namespace

int Covering::surfaces_before(const glm::dvec3& world, double apart) const {
  Ray ray = view_.ray_to(world);
  ray.to -= apart / glm::length(ray.direction);
  int count = 0;
  for (const CurveModel& model : models_) {
    const glm::dvec3 target(model.to_mesh * glm::dvec4(world, 1.0));
    count += model.source->faces().count_passed(in_mesh(ray, model), target);
  }
  return count;
}

int Covering::object_behind(const glm::dvec2& pixel, double nearness) const {
  Ray ray = view_.ray_through(pixel, nearness);
  ray.from = 1.0;
  int object = 0;
  for (const CurveModel& model : models_) {
    const std::optional<double> hit = model.source->faces().first_hit(in_mesh(ray, model));
    if (!hit || *hit > ray.to) continue;
    ray.to = *hit;
    object = model.object_id;
  }
  return object;
}

std::vector<ViewEdge> view_edges(std::vector<ViewLine>& lines) {
  std::vector<ViewEdge> edges;
  for (uint32_t i = 0; i < lines.size(); ++i) {
    ViewLine& line = lines[i];
    start_at_change(line);
    ViewEdge edge{i, 0, 0, 0.0, 0, {}};
    for (uint32_t at = 1; at < line.points.size(); ++at) {
      edge.length_px += step_px(line.points[at - 1], line.points[at]);
      edge.to = at;
      if (!line.follows && !line.points[at].change && at + 1 < line.points.size()) continue;
      edges.push_back(edge);
      edge = {i, at, at, 0.0, 0, {}};
    }
  }
  return edges;
}

void decide_covering(std::span<ViewEdge> edges, const std::vector<ViewLine>& lines,
                     const Covering& covering) {
  const std::vector<uint32_t> asked = asked_edges(edges, lines);
  for_each_in_parallel(asked.size(), [&](size_t i) {
    ViewEdge& edge = edges[asked[i]];
    decide(edge, lines[edge.line], covering);
  });
  // What lies between them goes with the one before, at a line's start with the one after.
  for (size_t i = 0; i < asked.size(); ++i) {
    const ViewEdge& edge = edges[asked[i]];
    const auto copy_to = [&](size_t other) {
      edges[other].covered = edge.covered;
      edges[other].behind = edge.behind;
    };
    const size_t next = i + 1 < asked.size() ? asked[i + 1] : edges.size();
    for (size_t j = asked[i] + 1; j < next && edges[j].line == edge.line; ++j) copy_to(j);
    for (size_t j = asked[i]; j > 0 && edges[j - 1].line == edge.line && (i == 0 || j - 1 > asked[i - 1]) &&
                              (i == 0 || edges[asked[i - 1]].line != edge.line);
         --j)
      copy_to(j - 1);
  }
}

}  // namespace inkbench
