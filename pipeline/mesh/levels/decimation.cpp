// SPDX-License-Identifier: MIT
// The one file that sees OpenMesh's decimater. OpenMesh gives the half-edges, the collapse and its legality;
// the quadrics and the loop are ours, for two reasons that measuring showed. `DecimaterT` asks every module
// about every half-edge and keeps the best: here the cheap question (the error) sorts the half-edges and the
// dear ones (legality, flips) are asked until one passes, which finds the same collapse. And `ModQuadricT`
// refuses the collapses that cost nothing when rounding makes their error negative, and knows no boundaries.
#include "pipeline/mesh/levels/decimation.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <cfloat>

#include "pipeline/mesh/weld_manifold.h"

namespace inkbench {
namespace {

namespace om = OpenMesh;

struct DoubleTraits : om::DefaultTraits {
  using Point = om::Vec3d;
  using Normal = om::Vec3d;
};
using HalfedgeMesh = om::TriMesh_ArrayKernelT<DoubleTraits>;
using Point = om::Vec3d;
using Vertex = om::VertexHandle;
using Halfedge = om::HalfedgeHandle;

/// Brought into the unit box around its middle: errors then neither vanish nor overflow whatever the mesh's
/// units.
std::vector<Point> normalised_points(const Mesh& mesh, const std::vector<uint32_t>& origin) {
  const Bounds bounds = bounds_of(mesh);
  const glm::dvec3 low = bounds.low;
  const glm::dvec3 extent = glm::dvec3(bounds.high) - low;
  const double longest = std::max({extent.x, extent.y, extent.z, DBL_MIN});
  std::vector<Point> points;
  points.reserve(origin.size());
  for (const uint32_t vertex : origin) {
    const glm::dvec3 p = (glm::dvec3(mesh.positions[vertex]) - low - extent * 0.5) / longest;
    points.emplace_back(p.x, p.y, p.z);
  }
  return points;
}

/// The pieces as half-edges. What lies on a cut is locked, so that pieces stay together there.
void build(const Mesh& mesh, const ManifoldPieces& pieces, HalfedgeMesh& halfedges) {
  halfedges.request_vertex_status();
  halfedges.reserve(pieces.origin.size(), pieces.triangles * 3 / 2 + 1, pieces.triangles);
  for (const Point& point : normalised_points(mesh, pieces.origin)) halfedges.add_vertex(point);
  for (size_t point = 0; point < pieces.origin.size(); ++point) {
    halfedges.status(Vertex(static_cast<int>(point))).set_locked(pieces.is_cut[point]);
  }
  for (size_t i = 0; i < pieces.corners.size(); ++i) {
    if (i % 1024 == 0) stop_if_asked();  // where a vertex has many faces, each takes long
    const auto& corners = pieces.corners[i];
    if (corners[0] == ManifoldPieces::kLeftOut) continue;
    Vertex vertices[3];
    for (int k = 0; k < 3; ++k) vertices[k] = Vertex(static_cast<int>(corners[k]));
    if (halfedges.add_face(vertices, 3).is_valid()) continue;
    // Not expected after the cuts. The face then stays as it is at every level.
    for (const Vertex vertex : vertices) halfedges.status(vertex).set_locked(true);
  }
}

std::array<Vertex, 3> corners_of(const HalfedgeMesh& mesh, om::FaceHandle face) {
  const Halfedge first = mesh.halfedge_handle(face);
  const Halfedge second = mesh.next_halfedge_handle(first);
  return {mesh.to_vertex_handle(first), mesh.to_vertex_handle(second),
          mesh.to_vertex_handle(mesh.next_halfedge_handle(second))};
}

Point area_normal(const Point& a, const Point& b, const Point& c) {
  return (b - a) % (c - a);
}

Point area_normal(const HalfedgeMesh& mesh, om::FaceHandle face) {
  const std::array<Vertex, 3> corners = corners_of(mesh, face);
  return area_normal(mesh.point(corners[0]), mesh.point(corners[1]), mesh.point(corners[2]));
}

/// Quadric errors, with a term that keeps boundaries in shape and one that decides where all errors are zero.
template <class MeshT>
class QuadricsT : public om::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(QuadricsT, MeshT, Quadrics);

  explicit QuadricsT(MeshT& mesh) : Base(mesh, false) {}

  void initialize() override {
    quadrics_.assign(Base::mesh().n_vertices(), Quadric());
    for (const auto face : Base::mesh().faces()) add_face(face);
    for (const auto edge : Base::mesh().edges()) {
      if (edge.is_boundary()) add_boundary(edge);
    }
    own_error_.resize(quadrics_.size());
    for (size_t i = 0; i < quadrics_.size(); ++i) update(Vertex(static_cast<int>(i)));
  }

  /// What it costs that `from` goes where `to` is. Never negative.
  float cost(Vertex from, Vertex to) {
    const Point& target = Base::mesh().point(to);
    const double error = quadrics_[index(from)](target) + own_error_[index(to)];
    const double length = (target - Base::mesh().point(from)).sqrnorm();
    return static_cast<float>(std::max(error, 0.0) + kEvenness * length * length);
  }

  float collapse_priority(const CollapseInfo& collapse) override { return cost(collapse.v0, collapse.v1); }

  void postprocess_collapse(const CollapseInfo& collapse) override {
    quadrics_[index(collapse.v1)] += quadrics_[index(collapse.v0)];
    update(collapse.v1);
  }

 private:
  using Quadric = om::Geometry::QuadricT<double>;

  /// On flat ground all errors are rounding. This prefers short edges there: it counts an edge as if the
  /// surface rose by a thousandth of it.
  static constexpr double kEvenness = 1e-6;
  /// The weight of a boundary's wall, whose area is that of the square over the edge.
  static constexpr double kBoundaryWeight = 100.0;

  static size_t index(Vertex vertex) { return static_cast<size_t>(vertex.idx()); }
  void update(Vertex vertex) {
    own_error_[index(vertex)] = quadrics_[index(vertex)](Base::mesh().point(vertex));
  }

  void add_plane(const Point& unit_normal, const Point& through, double weight, Vertex vertex) {
    Quadric quadric(unit_normal[0], unit_normal[1], unit_normal[2], -(unit_normal | through));
    quadrics_[index(vertex)] += quadric *= weight;
  }

  void add_face(om::FaceHandle face) {
    const MeshT& mesh = Base::mesh();
    const std::array<Vertex, 3> corners = corners_of(mesh, face);
    const Point normal = area_normal(mesh, face);
    const double length = normal.norm();
    if (!(length > 0.0)) return;
    for (const Vertex corner : corners)
      add_plane(normal / length, mesh.point(corners[0]), length / 2, corner);
  }

  /// A wall through the edge, upright on its face.
  void add_boundary(const om::SmartEdgeHandle& edge) {
    MeshT& mesh = Base::mesh();
    const auto inner = edge.h0().is_boundary() ? edge.h1() : edge.h0();
    const Point a = mesh.point(inner.from());
    const Point along = mesh.point(inner.to()) - a;
    const Point wall = along % area_normal(a, mesh.point(inner.to()), mesh.point(inner.next().to()));
    const double length = wall.norm();
    if (!(length > 0.0)) return;
    for (const Vertex end : {Vertex(inner.from()), Vertex(inner.to())})
      add_plane(wall / length, a, kBoundaryWeight * along.sqrnorm(), end);
  }

  std::vector<Quadric> quadrics_;
  std::vector<double> own_error_;  ///< Each quadric at its own vertex.
};

/// Refuses collapses that turn a face too far or away from all it stands for, fold it onto a neighbour, or
/// leave a sliver worse than what was there.
template <class MeshT>
class TurnsT : public om::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(TurnsT, MeshT, Turns);

  explicit TurnsT(MeshT& mesh) : Base(mesh, true) {}

  void initialize() override {
    const MeshT& mesh = Base::mesh();
    facing_.assign(mesh.n_vertices(), Point(0.0));
    for (const auto face : mesh.faces()) {
      const Point normal = area_normal(mesh, face);
      for (const Vertex corner : corners_of(mesh, face)) facing_[corner.idx()] += normal;
    }
  }

  float collapse_priority(const CollapseInfo& collapse) override {
    const MeshT& mesh = Base::mesh();
    // Once around `v0`: first the face that vanishes on the left, last the one on the right.
    Change last;
    Halfedge edge = collapse.v0v1;
    do {
      const Change change = mesh.face_handle(edge).is_valid() ? change_of(collapse, edge) : Change();
      if (!change.is_allowed || makes_fold(last, change)) return Base::ILLEGAL_COLLAPSE;
      last = change;
      edge = mesh.ccw_rotated_halfedge_handle(edge);
    } while (edge != collapse.v0v1);
    return Base::LEGAL_COLLAPSE;
  }

  void postprocess_collapse(const CollapseInfo& collapse) override {
    facing_[collapse.v1.idx()] += facing_[collapse.v0.idx()];
  }

 private:
  /// Twice the area over the longest side squared; the most is 0.87. Below, a face's direction is mostly
  /// rounding.
  static constexpr double kSliver = 1e-3;

  static double fatness(const Point& normal, const Point& a, const Point& b, const Point& c) {
    return normal.norm() / std::max({(b - a).sqrnorm(), (c - b).sqrnorm(), (a - c).sqrnorm(), DBL_MIN});
  }

  /// A face around `v0`, by its area normals. In place of one that vanishes comes the face behind it.
  struct Change {
    Point before{0.0};
    Point after{0.0};
    bool is_allowed = true;
    bool was_fold = false;  ///< Between the vanishing face and the one behind it.
  };

  /// Do faces of these area normals lie nearly on each other? (150 degrees between them.)
  static bool is_fold(const Point& a, const Point& b) {
    const double turn = a | b;
    return turn < 0.0 && turn * turn > 0.75 * a.sqrnorm() * b.sqrnorm();
  }

  /// Folds that were there may stay: a mesh may have knife edges.
  static bool makes_fold(const Change& a, const Change& b) {
    return is_fold(a.after, b.after) && !is_fold(a.before, b.before) && !a.was_fold && !b.was_fold;
  }

  /// What becomes of the face on the left of `edge`, which leaves `v0`.
  Change change_of(const CollapseInfo& collapse, Halfedge edge) {
    const MeshT& mesh = Base::mesh();
    const om::FaceHandle face = mesh.face_handle(edge);
    const Halfedge opposite = mesh.next_halfedge_handle(edge);
    const om::FaceHandle behind = mesh.face_handle(mesh.opposite_halfedge_handle(opposite));
    const Point beside = behind.is_valid() ? area_normal(mesh, behind) : Point(0.0);
    const Vertex second = mesh.to_vertex_handle(edge);
    const Vertex third = mesh.to_vertex_handle(opposite);
    Change change;
    change.before = area_normal(collapse.p0, mesh.point(second), mesh.point(third));
    if (face == collapse.fl || face == collapse.fr) {
      change.after = beside;
      change.was_fold = is_fold(change.before, beside);
    } else {
      change.after = area_normal(collapse.p1, mesh.point(second), mesh.point(third));
      change.is_allowed = may_move(collapse, second, third, change.before, change.after) &&
                          (!is_fold(change.after, beside) || is_fold(change.before, beside));
    }
    return change;
  }

  /// May the face of `v0`, `second` and `third`, with the area normal `before`, become that of `v1`, `second`
  /// and `third`, with `after`?
  bool may_move(const CollapseInfo& collapse, Vertex second, Vertex third, Point before, const Point& after) {
    const Point& b = Base::mesh().point(second);
    const Point& c = Base::mesh().point(third);
    const double fat = fatness(after, collapse.p1, b, c);
    if (!(fat > 0.0) || (fat < kSliver && fat < fatness(before, collapse.p0, b, c))) return false;
    // A face without area has no direction: it may open as its surroundings lie.
    if (!(before.sqrnorm() > 0.0)) before = surroundings(collapse.v0);
    const Point region = facing_[collapse.v0.idx()] + facing_[collapse.v1.idx()] + facing_[second.idx()] +
                         facing_[third.idx()];
    // A face that looks away already may: the mesh came so.
    if ((after | region) <= 0.0 && (before | region) > 0.0) return false;
    const double turn = after | before;
    return turn > 0.0 && turn * turn >= kMaxTurnCosine * kMaxTurnCosine * after.sqrnorm() * before.sqrnorm();
  }

  Point surroundings(Vertex vertex) {
    Point sum(0.0);
    for (const auto face : Base::mesh().vf_range(vertex)) sum += area_normal(Base::mesh(), face);
    return sum;
  }

  /// For each vertex the area normals of the original faces around it and around all that went into it.
  std::vector<Point> facing_;
};

/// Refuses collapses that would carry a boundary too far from where it was.
template <class MeshT>
class BoundariesT : public om::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(BoundariesT, MeshT, Boundaries);

  explicit BoundariesT(MeshT& mesh) : Base(mesh, true) {}

  void initialize() override {
    Point low(DBL_MAX), high(-DBL_MAX);
    for (const auto vertex : Base::mesh().vertices()) {
      low.minimize(Base::mesh().point(vertex));
      high.maximize(Base::mesh().point(vertex));
    }
    max_shift_ = kBoundaryShift * (high - low).norm();
    shift_.assign(Base::mesh().n_vertices(), 0.0F);
  }

  float collapse_priority(const CollapseInfo& collapse) override {
    if (!Base::mesh().is_boundary(collapse.v0)) return Base::LEGAL_COLLAPSE;
    return shift_after(collapse) <= max_shift_ ? Base::LEGAL_COLLAPSE : Base::ILLEGAL_COLLAPSE;
  }

  void preprocess_collapse(const CollapseInfo& collapse) override {
    if (!Base::mesh().is_boundary(collapse.v0)) return;
    const auto shift = static_cast<float>(shift_after(collapse));
    for (const Vertex end : {collapse.v1, other_end(collapse)})
      shift_[end.idx()] = std::max(shift_[end.idx()], shift);
  }

 private:
  /// The boundary edge that will be runs from `v1` to this one.
  Vertex other_end(const CollapseInfo& collapse) {
    const HalfedgeMesh& mesh = Base::mesh();
    const Halfedge out = mesh.halfedge_handle(collapse.v0);  // of a boundary vertex always the boundary's
    const Vertex next = mesh.to_vertex_handle(out);
    return next != collapse.v1 ? next : mesh.from_vertex_handle(mesh.prev_halfedge_handle(out));
  }

  double shift_after(const CollapseInfo& collapse) {
    const Point& end = Base::mesh().point(other_end(collapse));
    const Point along = end - collapse.p1;
    const double square = along.sqrnorm();
    const double t =
        square > 0.0 ? std::clamp(((collapse.p0 - collapse.p1) | along) / square, 0.0, 1.0) : 0.0;
    return shift_[collapse.v0.idx()] + (collapse.p0 - collapse.p1 - along * t).norm();
  }

  double max_shift_ = 0.0;
  std::vector<float> shift_;  ///< For each boundary vertex, how far the boundary beside it may have moved.
};

using Quadrics = QuadricsT<HalfedgeMesh>;
using Turns = TurnsT<HalfedgeMesh>;
using Boundaries = BoundariesT<HalfedgeMesh>;

/// The decimation loop of `DecimaterT` with the dear questions asked last, and a record.
class RecordingDecimater : public om::Decimater::BaseDecimaterT<HalfedgeMesh> {
 public:
  RecordingDecimater(HalfedgeMesh& mesh, const StopAsked& stop)
      : BaseDecimaterT(mesh),
        stop_(stop),
        target_(mesh.n_vertices()),
        cost_(mesh.n_vertices(), -1.0F),
        heap_position_(mesh.n_vertices(), -1),
        heap_(HeapInterface{&cost_, &heap_position_}),
        valence_(mesh.n_vertices()) {
    for (const auto vertex : mesh.vertices()) valence_[vertex.idx()] = mesh.valence(vertex);
    add(boundaries_);
    add(turns_);
    add(quadrics_);
    initialize();
  }

  /// Until there are at most `enough` faces or nothing can be collapsed any more; appends to
  /// `record.collapses` and `record.faces`.
  void run(CollapseRecord& record, size_t enough) {
    // A vertex for which nothing passes comes up again only when a neighbour goes, though a change farther
    // off may set it free; so the end is reached when a whole round finds nothing.
    size_t before;
    do {
      before = record.collapses.size();
      for (const auto vertex : mesh().vertices()) {
        if (mesh().status(vertex).deleted()) continue;
        consider(vertex);
        stop_if_asked();
      }
      while (!heap_.empty() && record.faces.back() > enough) {
        step(record);
        stop_if_asked();
      }
    } while (record.faces.back() > enough && record.collapses.size() > before);
  }

 private:
  struct HeapInterface {
    std::vector<float>* cost;
    std::vector<int>* position;

    bool less(Vertex a, Vertex b) const { return (*cost)[a.idx()] < (*cost)[b.idx()]; }
    bool greater(Vertex a, Vertex b) const { return (*cost)[a.idx()] > (*cost)[b.idx()]; }
    int get_heap_position(Vertex vertex) const { return (*position)[vertex.idx()]; }
    void set_heap_position(Vertex vertex, int place) const { (*position)[vertex.idx()] = place; }
  };
  struct Candidate {
    float cost;
    Halfedge halfedge;
  };

  void stop_if_asked() {
    constexpr unsigned kOften = 1024;
    if (++steps_ % kOften == 0) inkbench::stop_if_asked(stop_);
  }

  /// Finds the vertex's cheapest collapse and puts it on the heap, or takes it off.
  void consider(Vertex vertex) {
    candidates_.clear();
    if (!mesh().status(vertex).locked() && valence_[vertex.idx()] <= kMostValence) {
      Quadrics& quadrics = module(quadrics_);
      for (auto edge = mesh().cvoh_begin(vertex); edge.is_valid(); ++edge)
        candidates_.push_back({quadrics.cost(vertex, mesh().to_vertex_handle(*edge)), *edge});
    }
    // The first of equals, as `DecimaterT` chooses: selection, since mostly the first one passes.
    for (size_t i = 0; i < candidates_.size(); ++i) {
      const auto best = std::ranges::min_element(candidates_.begin() + static_cast<std::ptrdiff_t>(i),
                                                 candidates_.end(), {}, &Candidate::cost);
      std::rotate(candidates_.begin() + static_cast<std::ptrdiff_t>(i), best, best + 1);
      if (passes(candidates_[i].halfedge)) return put(vertex, candidates_[i]);
    }
    if (heap_.is_stored(vertex)) heap_.remove(vertex);
  }

  bool passes(Halfedge halfedge) {
    const CollapseInfo collapse(mesh(), halfedge);
    return valence_after(collapse) <= kMostValence && is_legal(collapse) &&
           module(boundaries_).collapse_priority(collapse) >= 0.0F &&
           module(turns_).collapse_priority(collapse) >= 0.0F;
  }

  /// How many edges there will be at `v1`, or are, if that is more: all that is asked about a collapse goes
  /// once around its ends.
  unsigned valence_after(const CollapseInfo& collapse) const {
    const unsigned shared = (collapse.vl.is_valid() ? 1 : 0) + (collapse.vr.is_valid() ? 1 : 0);
    const unsigned before = valence_[collapse.v1.idx()];
    return std::max(before, before + valence_[collapse.v0.idx()] - 2 - shared);
  }

  /// Does the collapse leave a surface as it should be? Like `is_collapse_legal`, but without going around
  /// `vl` and `vr`, which may have any number of edges.
  bool is_legal(const CollapseInfo& collapse) {
    HalfedgeMesh& m = mesh();
    if (m.status(collapse.v0).locked() || !m.is_collapse_ok(collapse.v0v1)) return false;
    const bool is_inner = collapse.vl.is_valid() && collapse.vr.is_valid();
    const bool is_tetrahedron = is_inner && valence_[collapse.vl.idx()] == 3 &&
                                valence_[collapse.vr.idx()] == 3 &&
                                m.find_halfedge(collapse.vl, collapse.vr).is_valid();
    if (is_tetrahedron) return false;
    // A border's vertex goes along the border.
    if (m.is_boundary(collapse.v0) && (is_inner || !m.is_boundary(collapse.v1))) return false;
    const Halfedge second = m.cw_rotated_halfedge_handle(collapse.v0v1);
    return m.cw_rotated_halfedge_handle(second) != collapse.v0v1;  // two faces at least
  }

  void count_edges(const CollapseInfo& collapse) {
    const unsigned shared = (collapse.vl.is_valid() ? 1 : 0) + (collapse.vr.is_valid() ? 1 : 0);
    valence_[collapse.v1.idx()] += valence_[collapse.v0.idx()] - 2 - shared;
    for (const Vertex side : {collapse.vl, collapse.vr}) {
      if (side.is_valid()) --valence_[side.idx()];
    }
  }

  void put(Vertex vertex, const Candidate& candidate) {
    target_[vertex.idx()] = candidate.halfedge;
    cost_[vertex.idx()] = candidate.cost;
    if (heap_.is_stored(vertex)) {
      heap_.update(vertex);
    } else {
      heap_.insert(vertex);
    }
  }

  void step(CollapseRecord& record) {
    const Vertex vertex = heap_.front();
    const Halfedge halfedge = target_[vertex.idx()];
    heap_.pop_front();
    // The faces behind the neighbours may have changed since it was put there, and they count too.
    // (OpenMesh's loop asks only about legality again, and forgets the vertex when that is gone.)
    if (!passes(halfedge)) return consider(vertex);
    CollapseInfo collapse(mesh(), halfedge);
    ring_.assign(mesh().cvv_begin(collapse.v0), mesh().cvv_end(collapse.v0));
    record.collapses.push_back(
        {static_cast<uint32_t>(collapse.v0.idx()), static_cast<uint32_t>(collapse.v1.idx())});
    const uint32_t fewer = (collapse.fl.is_valid() ? 1 : 0) + (collapse.fr.is_valid() ? 1 : 0);
    record.faces.push_back(record.faces.back() - fewer);
    preprocess_collapse(collapse);
    count_edges(collapse);
    mesh().collapse(halfedge);
    postprocess_collapse(collapse);
    for (const Vertex neighbour : ring_) consider(neighbour);
  }

  /// Vertices of more edges stay until those around them have gone, and nothing is collapsed into them: what
  /// is asked about a collapse takes as long as there are edges at its ends, and they would be asked about
  /// with every neighbour that goes. Far above what meshes have, so that the order of collapses stays.
  static constexpr unsigned kMostValence = 128;

  const StopAsked& stop_;
  unsigned steps_ = 0;
  Quadrics::Handle quadrics_;
  Turns::Handle turns_;
  Boundaries::Handle boundaries_;
  std::vector<Halfedge> target_;
  std::vector<float> cost_;
  std::vector<int> heap_position_;
  om::Utils::HeapT<Vertex, HeapInterface> heap_;
  std::vector<unsigned> valence_;  ///< Of each vertex.
  std::vector<Candidate> candidates_;
  std::vector<Vertex> ring_;
};

void decimate_by_openmesh(HalfedgeMesh& halfedges, size_t faces, bool without_flips) {
  om::Decimater::DecimaterT<HalfedgeMesh> decimater(halfedges);
  om::Decimater::ModQuadricT<HalfedgeMesh>::Handle quadrics;
  om::Decimater::ModNormalFlippingT<HalfedgeMesh>::Handle flips;
  decimater.add(quadrics);
  if (without_flips) {
    halfedges.request_face_normals();
    halfedges.update_face_normals();
    decimater.add(flips);
  }
  decimater.initialize();
  decimater.decimate_to_faces(0, faces);
}

}  // namespace

CollapseRecord record_collapses(const Mesh& mesh, const StopAsked& stop) {
  ManifoldPieces pieces = cut_to_manifold(mesh);
  CollapseRecord record;
  record.faces.push_back(static_cast<uint32_t>(pieces.triangles));
  record.collapses.reserve(pieces.origin.size());
  record.faces.reserve(pieces.origin.size() + 1);
  HalfedgeMesh halfedges;
  build(mesh, pieces, halfedges);
  RecordingDecimater(halfedges, stop).run(record, 0);
  record.corners = std::move(pieces.corners);
  record.origin = std::move(pieces.origin);
  record.next_equal = std::move(pieces.next_equal);
  return record;
}

std::vector<std::array<uint32_t, 3>> decimate_directly(const Mesh& mesh, size_t faces,
                                                       DecimationRules rules) {
  const ManifoldPieces pieces = cut_to_manifold(mesh);
  HalfedgeMesh halfedges;
  build(mesh, pieces, halfedges);
  halfedges.request_face_status();  // outlives the decimater: it tells deleted faces
  if (rules == DecimationRules::ours) {
    CollapseRecord unused;
    unused.faces.push_back(static_cast<uint32_t>(pieces.triangles));
    RecordingDecimater(halfedges, {}).run(unused, faces);
  } else {
    decimate_by_openmesh(halfedges, faces, rules == DecimationRules::quadrics_no_flip);
  }
  std::vector<std::array<uint32_t, 3>> triangles;
  for (const auto face : halfedges.faces()) {
    if (halfedges.status(face).deleted()) continue;
    const std::array<Vertex, 3> corners = corners_of(halfedges, face);
    triangles.push_back({static_cast<uint32_t>(corners[0].idx()), static_cast<uint32_t>(corners[1].idx()),
                         static_cast<uint32_t>(corners[2].idx())});
  }
  return triangles;
}

}  // namespace inkbench
