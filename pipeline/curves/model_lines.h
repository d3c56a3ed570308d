// SPDX-License-Identifier: MIT
// The lines of one model for one eye, before anything is known of what covers them. In: its source, the eye.
// Out: lines in the world, each mesh edge in one line at most.
#pragma once

#include <vector>

#include "pipeline/curves/covering.h"
#include "pipeline/curves/object_curves.h"

namespace inkbench {

/// `Curve::places` of one object: a vertex; an edge through a face; where a line of a class of the smooth
/// surface crosses an edge. 0 is none.
uint64_t vertex_place(const CurveModel& model, uint32_t vertex);
uint64_t piercing_place(const CurveModel& model, const Piercing& piercing);
uint64_t crossing_place(const CurveModel& model, CurveClass line_class, uint32_t crossing);

/// Edges of one model that go through faces, its own or others', in order of edge and place.
struct PiercedEdge {
  uint32_t edge = 0;
  double along = 0.0;
  uint64_t place = 0;
  bool operator<(const PiercedEdge& other) const {
    return edge == other.edge ? along < other.along : edge < other.edge;
  }
};
std::vector<PiercedEdge> pierced_edges(std::span<const CurveModel> models, std::span<const ModelCuts> cuts,
                                       int model);

/// Silhouettes and boundaries (whatever `params` say, since they cover) and creases.
std::vector<ViewLine> mesh_edge_lines(const CurveModel& model, int index, const CurveView& view,
                                      const CurvesParams& params, std::span<const PiercedEdge> pierced);

/// Lines of the smooth surface, as far as they are asked for; its silhouettes follow the mesh's.
std::vector<ViewLine> surface_lines(const CurveModel& model, int index, const CurveView& view,
                                    const CurvesParams& params);

/// Cuts of two models or, where both are one, of one with itself.
std::vector<ViewLine> cut_lines(std::span<const CurveModel> models, const ModelCuts& cuts);

}  // namespace inkbench
