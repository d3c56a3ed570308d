// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "curves_support.h"

namespace inkbench {
namespace {

const Mesh kSquare = [] {
  Mesh mesh;  // of side 2 in the xy plane, facing +z
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.normals.assign(4, {0.0F, 0.0F, 1.0F});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}();

/// Pixels for a length of 1 at the distance.
double scale_at(double distance) {
  return 200.0 / distance;
}

TEST(CurveVisibility, AnEdgeBehindASquareIsCutWhereTheSquaresBordersCrossIt) {
  CurveScene scene;
  scene.add(kSquare, moved(0, 0, 2)).add(kSquare, moved(0, 1.5F, 0, 2.0F));
  // The nearer one, 4 away, spans +-50 px; the other's lower border, 6 away, runs at y = -0.5 over +-66.7.
  const Curves curves = scene.find();
  double hidden = 0.0;
  std::vector<Curve> of_second;
  for (const Curve& curve : curves.curves) {
    if (curve.object_id != 2) continue;
    of_second.push_back(curve);
    if (curve.covered == 0) continue;
    EXPECT_EQ(curve.covered, 1);
    EXPECT_EQ(curve.start, CurveEnd::crossing);
    EXPECT_EQ(curve.end, CurveEnd::crossing);
    const double left = std::min(curve.points.front().x, curve.points.back().x);
    const double right = std::max(curve.points.front().x, curve.points.back().x);
    EXPECT_NEAR(left, 200.0 - scale_at(4), 0.01);
    EXPECT_NEAR(right, 200.0 + scale_at(4), 0.01);
    hidden += length_px(curve);
  }
  EXPECT_NEAR(hidden, 2 * scale_at(4), 0.02);
  EXPECT_EQ(of_second.size(), 2U) << "one curve around what is seen, one behind the square";
}

TEST(CurveVisibility, HiddenCurvesCountTheSurfacesBeforeThem) {
  CurveScene scene;
  scene.add(make_box(1), moved(0, 0, 2))
      .add(kSquare, moved(0, 0, 1, 0.5F))
      .add(kSquare, moved(0, 0, 0, 0.4F));
  std::map<int, int> covered;
  for (const Curve& curve : scene.find().curves) {
    if (curve.object_id == 3) covered[curve.covered] += 1;
  }
  EXPECT_EQ(covered, (std::map<int, int>{{3, 1}})) << "the box's front and back, and the square between";
}

TEST(CurveVisibility, ABordersFarSideTellsAnotherObjectFromNothing) {
  CurveScene scene;
  scene.add(kSquare, moved(0, 0, 1)).add(kSquare, moved(2, 0, 0, 2.0F));
  std::map<CurveClass, double> of_first;
  for (const Curve& curve : scene.find().curves) {
    if (curve.object_id == 1) of_first[curve.curve_class] += length_px(curve);
  }
  // 5 away, the left border of the other, 6 away at x = 0, is seen at x = 0 as well.
  EXPECT_NEAR(of_first[CurveClass::object], 4 * scale_at(5), 1.0);
  EXPECT_NEAR(of_first[CurveClass::boundary], 4 * scale_at(5), 1.0);
}

TEST(CurveVisibility, ABoxShowsNineOfItsEdgesAndHidesThree) {
  CurveScene scene;
  scene.request.camera.eye = {3.0F, 4.0F, 5.0F};
  scene.add(make_box(1));
  const Curves curves = scene.find();
  const CurveView view(scene.request.camera, 400, 400);
  double visible = 0.0;
  double hidden = 0.0;
  const auto pixel = [&](int corner) {
    const glm::dvec3 at((corner & 1) - 0.5, ((corner >> 1) & 1) - 0.5, ((corner >> 2) & 1) - 0.5);
    return glm::dvec2(view.to_pixel(view.to_clip(at)));
  };
  for (int a = 0; a < 8; ++a) {
    for (int b = a + 1; b < 8; ++b) {
      if (std::popcount(static_cast<unsigned>(a ^ b)) != 1) continue;
      (a == 0 || b == 0 ? hidden : visible) += glm::distance(pixel(a), pixel(b));
    }
  }
  double drawn[2] = {0.0, 0.0};
  for (const Curve& curve : curves.curves) {
    drawn[curve.covered > 0] += length_px(curve);
    if (curve.covered > 0) {
      EXPECT_EQ(curve.covered, 1);
    }
  }
  EXPECT_NEAR(drawn[0], visible, 1e-3);
  EXPECT_NEAR(drawn[1], hidden, 1e-3);
}

TEST(CurveVisibility, ATorusSeenFromTheSideHasItsCusps) {
  CurveScene scene;
  scene.request.camera.eye = {0.0F, 2.2F, 5.0F};
  scene.add(make_torus(96, 0.4F));
  scene.request.params.silhouette = SilhouetteKind::mesh;
  scene.request.params.crease = false;
  double seen = 0.0;
  double behind_itself = 0.0;
  int cusps = 0;
  for (const Curve& curve : scene.find().curves) {
    (curve.covered == 0 ? seen : behind_itself) += length_px(curve);
    cusps += (curve.start == CurveEnd::cusp) + (curve.end == CurveEnd::cusp);
  }
  EXPECT_GT(seen, 0.0);
  EXPECT_GT(behind_itself, 5.0) << "the hole's far rim goes on behind the near one";
  EXPECT_GE(cusps, 2) << "at both ends of the hole";
}

TEST(CurveVisibility, WhereABoxSticksInAFloorTheirCutIsACurveAndItsEdgesChange) {
  CurveScene scene;
  scene.request.camera.eye = {2.0F, 2.0F, 5.0F};
  scene.add(make_plane(1), moved(0, 0, 0, 3.0F)).add(make_box(1), moved(0.1F, 0.2F, 0.05F));
  const Curves curves = scene.find();
  const CurveView view(scene.request.camera, 400, 400);
  const auto pixel = [&](double x, double z) { return glm::dvec2(view.to_pixel(view.to_clip({x, 0.0, z}))); };
  // Of the square in the floor two sides are seen.
  const double seen =
      glm::distance(pixel(-0.4, 0.55), pixel(0.6, 0.55)) + glm::distance(pixel(0.6, 0.55), pixel(0.6, -0.45));
  EXPECT_NEAR(length_of(curves, CurveClass::intersection, true), seen, 0.05);
  // What of the box's upright edges lies below the floor is hidden.
  for (const Curve& curve : curves.curves) {
    if (curve.object_id != 2 || curve.curve_class == CurveClass::intersection) continue;
    const float lowest = std::max(curve.points.front().y, curve.points.back().y);
    if (curve.covered == 0) {
      EXPECT_LE(lowest, std::max(pixel(-0.4, 0.55).y, pixel(0.6, 0.55).y) + 0.01);
    }
  }
}

TEST(CurveVisibility, NoMeshEdgeIsInTwoCurves) {
  CurveScene scene;
  scene.request.camera.eye = {2.0F, 2.5F, 4.0F};
  scene.request.params.crease_angle = 10.0F;
  scene.add(rough_sphere(16, 0.1, 5));
  std::set<std::pair<uint64_t, uint64_t>> steps;
  size_t count = 0;
  for (const Curve& curve : scene.find().curves) {
    for (size_t i = 1; i < curve.places.size(); ++i) {
      const auto [a, b] = std::minmax(curve.places[i - 1], curve.places[i]);
      if (a == 0) continue;
      ++count;
      EXPECT_TRUE(steps.insert({a, b}).second);
    }
  }
  EXPECT_GT(count, 100U);
}

TEST(CurveVisibility, IsTheSameEveryTime) {
  CurveScene scene;
  scene.request.camera.eye = {1.0F, 1.5F, 3.0F};
  scene.add(rough_sphere(40, 0.2, 6)).add(rough_sphere(20, 0.2, 9), moved(0.7F, 0.3F, 0.2F));
  const Curves once = scene.find();
  const Curves again = scene.find();
  ASSERT_EQ(once.curves.size(), again.curves.size());
  for (size_t i = 0; i < once.curves.size(); ++i) {
    EXPECT_EQ(once.curves[i].points, again.curves[i].points);
    EXPECT_EQ(once.curves[i].covered, again.curves[i].covered);
  }
}

TEST(CurveVisibility, BadMeshesAndEyesWithinThemEndWell) {
  Mesh nothing;
  Mesh needles = make_sphere(12);  // flat faces, faces on one line, faces twice, faces turned round
  for (glm::vec3& point : needles.positions) point.z *= 1e-6F;
  needles.triangles.push_back(needles.triangles[0]);
  needles.triangles.push_back({needles.triangles[1][1], needles.triangles[1][0], needles.triangles[1][2]});
  needles.triangles.push_back({0, 1, 1});
  for (const SilhouetteKind kind : {SilhouetteKind::mesh, SilhouetteKind::smooth}) {
    CurveScene scene;
    scene.request.params.silhouette = kind;
    scene.add(nothing).add(needles).add(needles).add(make_box(1), moved(0, 0, 6, 3.0F));
    for (const Curve& curve : scene.find().curves) {
      ASSERT_GE(curve.points.size(), 2U);
      ASSERT_EQ(curve.points.size(), curve.places.size());
      for (const glm::vec2& point : curve.points) {
        ASSERT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
        ASSERT_LE(std::abs(point.x - 200.0F), 200.0F + kCurveMarginPx + 0.01F);
      }
    }
  }
}

}  // namespace
}  // namespace inkbench
