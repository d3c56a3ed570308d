// SPDX-License-Identifier: MIT
#include "pipeline/curves/nearest_silhouette.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "pipeline/base/parallel.h"

namespace inkbench {
namespace {

/// Surfaces that lie no more than so many faces' heights before a line may be the ones that it runs on.
constexpr double kApartFaces = 3.0;

double squared(const glm::dvec3& vector) {
  return glm::dot(vector, vector);
}

double squared_distance(const Box& box, const glm::dvec3& point) {
  return squared(point - glm::clamp(point, glm::dvec3(box.low), glm::dvec3(box.high)));
}

double squared_distance(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& point) {
  const glm::dvec3 way = b - a;
  const double length = squared(way);
  const double along = length > 0.0 ? std::clamp(glm::dot(point - a, way) / length, 0.0, 1.0) : 0.0;
  return squared(point - (a + along * way));
}

/// Steps of silhouettes, each with the part that it belongs to.
class Steps {
 public:
  void add(const ViewEdge& edge, uint32_t number, const ViewLine& line) {
    for (uint32_t at = edge.from; at < edge.to; ++at) {
      ends_.push_back({line.points[at].world, line.points[at + 1].world});
      part_of_.push_back(number);
      Box box;
      box.add(glm::vec3(ends_.back()[0]));
      box.add(glm::vec3(ends_.back()[1]));
      boxes_.push_back(box);
    }
  }
  void close() { tree_ = BoxTree(boxes_); }

  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    uint32_t part = 0;
  };
  Nearest nearest(const glm::dvec3& point) const {
    Nearest found;
    double least = found.distance;
    tree_.walk([&](uint32_t node) { return squared_distance(tree_.nodes()[node].box, point) < least; },
               [&](uint32_t step) {
                 const auto& [a, b] = ends_[step];
                 const double distance = squared_distance(a, b, point);
                 if (distance > least || (distance == least && part_of_[step] >= found.part)) return;
                 least = distance;
                 found = {std::sqrt(distance), part_of_[step]};
               });
    return found;
  }

 private:
  std::vector<std::array<glm::dvec3, 2>> ends_;
  std::vector<uint32_t> part_of_;
  std::vector<Box> boxes_;
  BoxTree tree_;
};

/// Of one model, those that are seen and those that are not.
struct Silhouettes {
  Steps visible, hidden;
};

}  // namespace

void follow_silhouettes(std::span<ViewEdge> edges, const std::vector<ViewLine>& lines,
                        const Covering& covering) {
  std::vector<Silhouettes> of_model;
  for (uint32_t i = 0; i < edges.size(); ++i) {
    const ViewLine& line = lines[edges[i].line];
    const auto model = static_cast<size_t>(line.model);
    if (of_model.size() <= model) of_model.resize(model + 1);
    if (!line.covers) continue;
    (edges[i].covered == 0 ? of_model[model].visible : of_model[model].hidden).add(edges[i], i, line);
  }
  for (Silhouettes& silhouettes : of_model) {
    silhouettes.visible.close();
    silhouettes.hidden.close();
  }
  for_each_in_parallel(edges.size(), [&](size_t i) {
    const ViewLine& line = lines[edges[i].line];
    if (!line.follows) return;
    const Silhouettes& silhouettes = of_model[static_cast<size_t>(line.model)];
    const glm::dvec3 middle = 0.5 * (line.points[edges[i].from].world + line.points[edges[i].to].world);
    const Steps::Nearest visible = silhouettes.visible.nearest(middle);
    const Steps::Nearest hidden = silhouettes.hidden.nearest(middle);
    const double across = line.steps[edges[i].from].across;
    const bool is_visible =
        visible.distance <= hidden.distance || (visible.distance <= hidden.distance + across &&
                                                covering.surfaces_before(middle, kApartFaces * across) == 0);
    const Steps::Nearest& nearest = is_visible ? visible : hidden;
    if (std::isinf(nearest.distance)) return;
    edges[i].covered = edges[nearest.part].covered;
    edges[i].behind = edges[nearest.part].behind;
  });
}

}  // namespace inkbench
