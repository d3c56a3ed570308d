// SPDX-License-Identifier: MIT
#include "pipeline/curves/smooth_silhouettes.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "pipeline/lines/chain.h"

namespace inkbench {
namespace {

class SilhouetteMaker {
 public:
  SilhouetteMaker(const SmoothSurface& surface, const Viewpoint& eye) : surface_(surface), eye_(eye) {}

  void add(uint32_t face) {
    const auto& corners = surface_.faces[face];
    std::array<double, 3> towards{};
    for (size_t i = 0; i < 3; ++i) {
      towards[i] = glm::dot(surface_.point_normals[corners[i]], eye_.from(surface_.positions[corners[i]]));
    }
    std::array<uint32_t, 2> ends{};
    size_t count = 0;
    for (size_t i = 0; i < 3; ++i) {
      const size_t j = (i + 1) % 3;
      if ((towards[i] >= 0.0) == (towards[j] >= 0.0)) continue;
      // From the smaller point on, so that both faces of the edge get the same.
      const bool forward = corners[i] < corners[j];
      const size_t a = forward ? i : j;
      const size_t b = forward ? j : i;
      const double along = towards[a] / (towards[a] - towards[b]);
      ends[count++] = node(surface_.crossings[face][i],
                           glm::mix(surface_.positions[corners[a]], surface_.positions[corners[b]], along));
    }
    if (count != 2) return;
    links_.push_back({ends[0], ends[1]});
    faces_.push_back(face);
  }

  std::vector<SurfaceLine> lines() const {
    std::vector<SurfaceLine> lines;
    for (const LinkedChain& chain : linked_chains(points_, links_, kAnyTurnDeg)) {
      SurfaceLine& line = lines.emplace_back();
      for (const uint32_t point : chain.points) {
        line.points.push_back(points_[point]);
        line.crossings.push_back(crossings_[point]);
      }
      for (const uint32_t link : chain.links) line.faces.push_back(faces_[link]);
    }
    return lines;
  }

 private:
  uint32_t node(uint32_t crossing, const glm::dvec3& point) {
    const auto [found, is_new] = nodes_.try_emplace(crossing, static_cast<uint32_t>(points_.size()));
    if (is_new) {
      points_.push_back(point);
      crossings_.push_back(crossing);
    }
    return found->second;
  }

  const SmoothSurface& surface_;
  const Viewpoint& eye_;
  std::unordered_map<uint32_t, uint32_t> nodes_;
  std::vector<glm::dvec3> points_;
  std::vector<uint32_t> crossings_;
  std::vector<Link> links_;
  std::vector<uint32_t> faces_;
};

}  // namespace

SmoothSilhouettes::SmoothSilhouettes(const SmoothSurface& surface) {
  std::vector<std::array<glm::dvec3, 3>> normals(surface.faces.size());
  std::vector<FacingItem> items(surface.faces.size());
  for (size_t f = 0; f < items.size(); ++f) {
    for (size_t i = 0; i < 3; ++i) {
      const uint32_t point = surface.faces[f][i];
      normals[f][i] = surface.point_normals[point];
      // The positions of a stretched surface are no floats.
      const glm::dvec3 size = glm::abs(surface.positions[point]) * 1e-7;
      items[f].box.add(glm::vec3(surface.positions[point] - size));
      items[f].box.add(glm::vec3(surface.positions[point] + size));
    }
    items[f].normals = normals[f];
  }
  tree_ = SilhouetteTree(items);
}

std::vector<SurfaceLine> SmoothSilhouettes::find(const SmoothSurface& surface, const Viewpoint& eye) const {
  std::vector<uint32_t> candidates;
  tree_.each_candidate(eye, [&](uint32_t face) { candidates.push_back(face); });
  std::sort(candidates.begin(), candidates.end());
  SilhouetteMaker maker(surface, eye);
  for (const uint32_t face : candidates) maker.add(face);
  return maker.lines();
}

}  // namespace inkbench
