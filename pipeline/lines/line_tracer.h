// SPDX-License-Identifier: MIT
// Lines through faces, step by step. In: steps between crossings of edges, each with a strength. Out: chains
// that are strong enough.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "pipeline/lines/chain.h"
#include "pipeline/lines/lines.h"

namespace inkbench {

class LineTracer {
 public:
  /// A place on an edge. Crossings with the same id are one.
  struct Crossing {
    uint32_t id = 0;
    glm::dvec3 point{0.0};
    double strength = 0.0;
  };

  /// Ids are smaller than `id_count`.
  explicit LineTracer(uint32_t id_count) : node_of_id_(id_count, kNoNode) {}

  /// The mean of three crossings of one face.
  static Crossing middle(uint32_t id, const std::array<Crossing, 3>& crossings);

  /// Through a face.
  void add_step(uint32_t face, const Crossing& a, const Crossing& b);

  /// Runs of a strength of at least `weak` that reach 1 somewhere and are at least `shortest` long.
  std::vector<SurfaceLine> lines(double weak, double shortest) const;

 private:
  uint32_t node(const Crossing& crossing);
  void add_runs(const LinkedChain& chain, double weak, double shortest,
                std::vector<SurfaceLine>& lines) const;
  SurfaceLine line(const LinkedChain& chain, size_t first, size_t last) const;

  static constexpr uint32_t kNoNode = std::numeric_limits<uint32_t>::max();

  std::vector<uint32_t> node_of_id_;
  std::vector<uint32_t> ids_;
  std::vector<glm::dvec3> points_;
  std::vector<double> strengths_;
  std::vector<Link> links_;
  std::vector<uint32_t> faces_;  ///< One for each link.
};

/// The lines with a class.
std::vector<Polyline3> of_class(LineClass line_class, std::vector<SurfaceLine> lines);

}  // namespace inkbench
