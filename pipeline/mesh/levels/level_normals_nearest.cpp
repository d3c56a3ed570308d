// SPDX-License-Identifier: MIT
#include "pipeline/mesh/levels/level_normals_nearest.h"

#include <algorithm>
#include <cassert>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace inkbench {
namespace {

constexpr uint32_t kLeafSize = 4;

double squared(const glm::dvec3& v) {
  return glm::dot(v, v);
}

double squared_distance(const glm::dvec3& p, const glm::vec3& low, const glm::vec3& high) {
  return squared(p - glm::clamp(p, glm::dvec3(low), glm::dvec3(high)));
}

/// Weights of the triangle's corners at its point nearest to `p` (Ericson, Real-Time Collision Detection,
/// 5.1.5).
glm::dvec3 nearest_weights(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                           const glm::dvec3& c) {
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const double d1 = glm::dot(ab, p - a);
  const double d2 = glm::dot(ac, p - a);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const double d3 = glm::dot(ab, p - b);
  const double d4 = glm::dot(ac, p - b);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const double d5 = glm::dot(ab, p - c);
  const double d6 = glm::dot(ac, p - c);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  const double along_b = d4 - d3;
  const double along_c = d5 - d6;
  if (va <= 0 && along_b >= 0 && along_c >= 0) {
    const double w = along_b + along_c > 0 ? along_b / (along_b + along_c) : 0;
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  return sum > 0 ? glm::dvec3(va, vb, vc) / sum : glm::dvec3(1, 0, 0);
}

}  // namespace

struct NearestNormals::Search {
  glm::dvec3 point;
  glm::vec3 towards;
  double best = std::numeric_limits<double>::max();  ///< Squared distance.
  float agreement = -2.0F;
  glm::vec3 normal{0.0F, 1.0F, 0.0F};
};

NearestNormals::NearestNormals(const Mesh& surface) : surface_(surface), order_(surface.triangles.size()) {
  assert(!surface.triangles.empty());
  std::iota(order_.begin(), order_.end(), 0U);
  std::vector<glm::vec3> middles;
  middles.reserve(order_.size());
  for (const auto& t : surface.triangles) {
    middles.push_back((surface.positions[t[0]] + surface.positions[t[1]] + surface.positions[t[2]]) / 3.0F);
  }
  nodes_.reserve(order_.size());
  build(0, static_cast<uint32_t>(order_.size()), middles);
  slack_ = squared(glm::dvec3(nodes_.front().high) - glm::dvec3(nodes_.front().low)) * 1e-14;
}

void NearestNormals::fit(Node& node, uint32_t begin, uint32_t end) const {
  node.low = glm::vec3(std::numeric_limits<float>::max());
  node.high = -node.low;
  for (uint32_t i = begin; i < end; ++i) {
    for (const uint32_t vertex : surface_.triangles[order_[i]]) {
      node.low = glm::min(node.low, surface_.positions[vertex]);
      node.high = glm::max(node.high, surface_.positions[vertex]);
    }
  }
}

void NearestNormals::build(uint32_t begin, uint32_t end, const std::vector<glm::vec3>& middles) {
  const size_t index = nodes_.size();
  fit(nodes_.emplace_back(), begin, end);
  if (end - begin <= kLeafSize) {
    nodes_[index].first = begin;
    nodes_[index].count = end - begin;
    return;
  }
  const glm::vec3 extent = nodes_[index].high - nodes_[index].low;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](uint32_t a, uint32_t b) { return middles[a][axis] < middles[b][axis]; });
  build(begin, middle, middles);
  nodes_[index].first = static_cast<uint32_t>(nodes_.size());
  build(middle, end, middles);
}

void NearestNormals::visit_leaf(const Node& node, Search& search) const {
  for (uint32_t i = node.first; i < node.first + node.count; ++i) {
    const auto& t = surface_.triangles[order_[i]];
    const glm::dvec3 a = surface_.positions[t[0]];
    const glm::dvec3 b = surface_.positions[t[1]];
    const glm::dvec3 c = surface_.positions[t[2]];
    const glm::dvec3 weights = nearest_weights(search.point, a, b, c);
    const double distance = squared(search.point - (weights.x * a + weights.y * b + weights.z * c));
    if (distance > search.best + slack_) continue;
    glm::dvec3 normal = weights.x * glm::dvec3(surface_.normals[t[0]]) +
                        weights.y * glm::dvec3(surface_.normals[t[1]]) +
                        weights.z * glm::dvec3(surface_.normals[t[2]]);
    if (squared(normal) < 1e-12) normal = glm::cross(b - a, c - a);
    if (!(squared(normal) > 0)) continue;
    normal = glm::normalize(normal);
    const float agreement = glm::dot(glm::vec3(normal), search.towards);
    if (distance < search.best - slack_ || agreement > search.agreement) {
      search.normal = normal;
      search.agreement = agreement;
    }
    search.best = std::min(search.best, distance);
  }
}

glm::vec3 NearestNormals::at(const glm::vec3& point, const glm::vec3& towards) const {
  Search search{point, towards};
  struct Pending {
    uint32_t node;
    double distance;
  };
  Pending stack[64];  // the tree halves 32-bit counts: it is no deeper than 33
  int size = 0;
  stack[size++] = {0, 0.0};
  while (size > 0) {
    const Pending top = stack[--size];
    if (top.distance > search.best + slack_) continue;
    const Node& node = nodes_[top.node];
    if (node.count > 0) {
      visit_leaf(node, search);
      continue;
    }
    const auto pending = [&](uint32_t child) {
      return Pending{child, squared_distance(search.point, nodes_[child].low, nodes_[child].high)};
    };
    Pending near = pending(top.node + 1);
    Pending far = pending(node.first);
    if (far.distance < near.distance) std::swap(near, far);
    stack[size++] = far;
    stack[size++] = near;
  }
  return search.normal;
}

}  // namespace inkbench
