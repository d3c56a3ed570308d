// SPDX-License-Identifier: MIT
// Lines of tier 1 that lie along mesh edges, in the mesh's own space, hidden parts included. In: topology and
// eye. Out: edges by class.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "pipeline/lines/chain.h"
#include "pipeline/lines/topology.h"
#include "pipeline/lines/viewpoint.h"
#include "pipeline/settings/judge_params.h"

namespace inkbench {

inline constexpr double kCreaseAngleDeg = JudgeParams{}.crease_angle;

/// 1: front-facing, -1: back-facing, 0: without a normal. A face is front-facing if dot(face normal, eye -
/// point) > 0, in orthographic views dot(face normal, direction towards the eye) > 0; one that is seen
/// exactly edge-on counts as back-facing. `mirrored`: the mesh is shown through a matrix with a negative
/// determinant, which turns its faces around.
int8_t face_facing(const MeshTopology& topology, uint32_t face, const Viewpoint& eye, bool mirrored = false);
/// Of all faces.
std::vector<int8_t> face_facings(const MeshTopology& topology, const Viewpoint& eye, bool mirrored = false);

/// Edges between a front-facing and a back-facing face. A non-manifold edge is one if it has faces of both
/// kinds, and among the front-facing ones those that run along it and those that run against it differ in
/// number: then no pairing of the faces hides it (two solids that touch in an edge, a sheet with two sides).
std::vector<uint32_t> silhouette_edges(const MeshTopology& topology, const std::vector<int8_t>& facings);
/// Those among `candidates`, in their order, without looking at other faces than theirs.
std::vector<uint32_t> silhouette_edges(const MeshTopology& topology, std::span<const uint32_t> candidates,
                                       const Viewpoint& eye, bool mirrored = false);

/// Edges with one face, less those that others of faces within the angle cover: where edges of unequal length
/// meet (T-junctions), the surface goes on.
std::vector<uint32_t> boundary_edges(const MeshTopology& topology, double angle_deg = kCreaseAngleDeg);

/// Edges whose face normals differ by more than the angle, measured with the mesh stretched by `stretch`. A
/// non-manifold edge is one if some face has no partner within the angle that runs against it.
std::vector<uint32_t> crease_edges(const MeshTopology& topology, double angle_deg = kCreaseAngleDeg,
                                   const glm::dmat3& stretch = glm::dmat3(1.0));

/// The end points of edges.
std::vector<Link> links_of(const MeshTopology& topology, const std::vector<uint32_t>& edges);

}  // namespace inkbench
