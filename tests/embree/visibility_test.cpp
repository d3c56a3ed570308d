// SPDX-License-Identifier: MIT
// What covers curves, judged by Embree, which shares no code with ours.
#include <embree3/rtcore.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <string>

#include "pipeline/curves/curve_finder.h"
#include "pipeline/mesh/levels/model_mesh.h"
#include "pipeline/settings/settings_file.h"
#include "tests/places.h"

namespace inkbench {
namespace {

/// What single precision is worth ten units from the eye: a place is that near to a plane that it lies in.
constexpr float kOnPlane = 1e-5F;

/// The way to a place on a line, and what must not count: faces in whose plane the place lies.
struct Question : RTCIntersectContext {
  glm::vec3 target{0.0F};
  float on_plane = 0.0F;
};

/// Faces that the line itself lies on do not cover it; single precision would meet them now and then.
void leave_out_own_faces(const RTCFilterFunctionNArguments* arguments) {
  const auto* question = static_cast<const Question*>(arguments->context);
  const auto* positions = static_cast<const glm::vec3*>(arguments->geometryUserPtr);
  const unsigned face = RTCHitN_primID(arguments->hit, arguments->N, 0);
  const glm::vec3 normal(RTCHitN_Ng_x(arguments->hit, arguments->N, 0),
                         RTCHitN_Ng_y(arguments->hit, arguments->N, 0),
                         RTCHitN_Ng_z(arguments->hit, arguments->N, 0));
  const float away = glm::dot(glm::normalize(normal), question->target - positions[3 * face]);
  if (std::abs(away) < question->on_plane) arguments->valid[0] = 0;
}

class Judge {
 public:
  explicit Judge(const CurveRequest& request)
      : device_(rtcNewDevice(nullptr)),
        scene_(rtcNewScene(device_)),
        view_(request.camera, request.width_px, request.height_px) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    for (const CurveRequestModel& model : request.models) add(model);
    rtcCommitScene(scene_);
  }
  Judge(const Judge&) = delete;
  Judge& operator=(const Judge&) = delete;
  ~Judge() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  bool is_hidden(const glm::dvec2& pixel, double nearness) const {
    const Ray way = view_.ray_through(pixel, nearness);
    Question question;
    rtcInitIntersectContext(&question);
    question.target = glm::vec3(way.at(1.0));
    question.on_plane = kOnPlane;
    RTCRay ray{};
    ray.org_x = static_cast<float>(way.origin.x);
    ray.org_y = static_cast<float>(way.origin.y);
    ray.org_z = static_cast<float>(way.origin.z);
    ray.dir_x = static_cast<float>(way.direction.x);
    ray.dir_y = static_cast<float>(way.direction.y);
    ray.dir_z = static_cast<float>(way.direction.z);
    ray.tnear = static_cast<float>(way.from);
    ray.tfar = 1.0F;
    ray.mask = 0xFFFFFFFFU;
    rtcOccluded1(scene_, &question, &ray);
    return ray.tfar < 0.0F;
  }

 private:
  void add(const CurveRequestModel& model) {
    soups_.push_back(std::make_unique<std::vector<glm::vec3>>());
    std::vector<glm::vec3>& soup = *soups_.back();
    for (const auto& face : model.mesh->triangles) {
      for (const uint32_t point : face)
        soup.emplace_back(model.to_world * glm::vec4(model.mesh->positions[point], 1.0F));
    }
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), soup.size()));
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), soup.size() / 3));
    for (unsigned i = 0; i < soup.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) vertices[3 * i + static_cast<unsigned>(axis)] = soup[i][axis];
      indices[i] = i;
    }
    rtcSetGeometryUserData(geometry, soup.data());
    rtcSetGeometryOccludedFilterFunction(geometry, leave_out_own_faces);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }

  RTCDevice device_;
  RTCScene scene_;
  CurveView view_;
  std::vector<std::unique_ptr<std::vector<glm::vec3>>> soups_;
};

struct Agreement {
  long asked = 0, agreed = 0;
  double share() const { return static_cast<double>(agreed) / static_cast<double>(asked); }
};

/// Every pixel along all curves, but within 1 px of their ends, where what covers them may change.
Agreement agreement_of(const CurveRequest& request, const Curves& curves) {
  const Judge judge(request);
  const auto nearness = [&](float depth) {  // even in the image, as `CurveView::to_pixel` gives it
    return is_orthographic(request.camera) ? -double{depth} : 1.0 / depth;
  };
  Agreement agreement;
  for (const Curve& curve : curves.curves) {
    const double length = length_px(curve);
    double before = 0.0;
    double next = 1.25;
    for (size_t i = 1; i < curve.points.size(); ++i) {
      const glm::dvec2 a(curve.points[i - 1]);
      const glm::dvec2 b(curve.points[i]);
      const double step = glm::distance(a, b);
      for (; next <= before + step && next < length - 1.0; next += 1.0) {
        const double along = (next - before) / step;
        const double near = glm::mix(nearness(curve.depths[i - 1]), nearness(curve.depths[i]), along);
        ++agreement.asked;
        agreement.agreed += judge.is_hidden(glm::mix(a, b, along), near) == (curve.covered > 0);
      }
      before += step;
    }
  }
  return agreement;
}

CurveRequest request_of(const Settings& settings) {
  CurveRequest request{.models = {},
                       .camera = settings.camera,
                       .params = settings.curves,
                       .width_px = settings.image.width,
                       .height_px = settings.image.height};
  for (const ModelParams& model : settings.models) {
    auto mesh = std::make_shared<Mesh>(make_model_mesh(model));
    const glm::mat4 to_world = model_matrix(model, bounds_of(*mesh));
    request.models.push_back(
        {mesh, KeyBuilder().add(model.name).key(), to_world, static_cast<int>(request.models.size()) + 1});
  }
  return request;
}

TEST(CurvesBesideEmbree, AgreeOnWhatIsHiddenOfTwentyModelsFromTwoSides) {
  const std::vector<std::string> meshes{"fandisk",  "couplingdown", "elephant", "lion-head", "triceratops",
                                        "rotor",    "anchor_dense", "knot1",    "cow",       "bones",
                                        "camel",    "pinion",       "hand",     "head",      "handle",
                                        "dragknob", "star",         "blobby",   "mushroom",  "spool"};
  ASSERT_EQ(meshes.size(), 20U);
  Agreement all;
  for (const std::string& mesh : meshes) {
    Settings settings = load_settings(source_folder() + "/data/scenes/model.toml");
    settings.image.width = settings.image.height = 1024;
    main_model(settings).mesh = "debian:libcgal-demo/" + mesh + ".off";
    CurveRequest request = request_of(settings);
    CurveFinder finder;
    for (const float side : {0.0F, 3.0F}) {
      request.camera.eye.x = settings.camera.eye.x - side;
      const Agreement one = agreement_of(request, finder.find(request));
      EXPECT_GE(one.share(), 0.999) << mesh << ": " << one.asked - one.agreed << " of " << one.asked;
      all.asked += one.asked;
      all.agreed += one.agreed;
    }
  }
  EXPECT_GT(all.asked, 200000);
  EXPECT_GE(all.share(), 0.9998);
}

TEST(CurvesBesideEmbree, AgreeOnThePapersSceneAlsoWithoutPerspective) {
  for (const CameraProjection projection : {CameraProjection::perspective, CameraProjection::orthographic}) {
    Settings settings = load_settings(source_folder() + "/data/scenes/paper.toml");
    settings.image.width = settings.image.height = 1024;
    settings.camera.projection = projection;
    const CurveRequest request = request_of(settings);
    CurveFinder finder;
    const Agreement agreement = agreement_of(request, finder.find(request));
    EXPECT_GE(agreement.share(), 0.999) << agreement.asked - agreement.agreed << " of " << agreement.asked;
  }
}

}  // namespace
}  // namespace inkbench
