// SPDX-License-Identifier: MIT
// Lines through faces, step by step. In: steps between crossings of edges, each with a strength. Out: chains
// that are strong enough.
#pragma once

#include <glm/vec3.hpp>
#include <unordered_map>
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

  void add_step(const Crossing& a, const Crossing& b);

  /// Runs of a strength of at least `weak` that reach 1 somewhere and are at least `shortest` long.
  std::vector<Polyline3> lines(LineClass line_class, double weak, double shortest) const;

 private:
  uint32_t node(const Crossing& crossing);
  void add_runs(const Chain& chain, LineClass line_class, double weak, double shortest,
                std::vector<Polyline3>& lines) const;

  std::unordered_map<uint32_t, uint32_t> node_of_id_;
  std::vector<glm::dvec3> points_;
  std::vector<double> strengths_;
  std::vector<Link> links_;
};

}  // namespace inkbench
