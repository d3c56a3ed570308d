// SPDX-License-Identifier: MIT
#include "tests/gl/detector_support.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "pipeline/passes/edges/decaudin.h"
#include "pipeline/passes/edges/decaudin_detector.h"
#include "pipeline/passes/edges/decaudin_gradient.h"
#include "pipeline/passes/edges/laplacian.h"
#include "pipeline/passes/edges/laplacian_detector.h"
#include "pipeline/passes/edges/mitchell.h"
#include "pipeline/passes/edges/mitchell_detector.h"
#include "pipeline/passes/edges/saito_takahashi.h"
#include "pipeline/passes/edges/saito_takahashi_detector.h"
#include "pipeline/passes/gbuffer/visible_depth.h"
#include "pipeline/passes/gbuffer/visible_range.h"
#include "pipeline/passes/placing/edge_classes.h"
#include "pipeline/passes/placing/edge_tiles.h"

namespace inkbench {
namespace {

/// Of visible surfaces in world units; 1e30 and 0 where there are none.
std::pair<double, double> visible_range_of(const Image& depth, const LensBlock& lens) {
  double nearest = 1e30, farthest = 0;
  for (const float value : depth.samples) {
    if (is_background(value)) continue;
    nearest = std::min(nearest, double{value} * lens.far);
    farthest = std::max(farthest, double{value} * lens.far);
  }
  return {nearest, farthest};
}

Image visible_depth_of(const Image& depth, const LensBlock& lens) {
  const auto [nearest, farthest] = visible_range_of(depth, lens);
  return make_image(depth.width_px, depth.height_px, [&, near = nearest, far = farthest](int x, int y) {
    return visible_depth(lens, near, far, depth.at(x, y));
  });
}

EdgeClass class_where(bool is_detected, const DetectorMaps& maps, const LensBlock& lens, int x, int y,
                      int reach) {
  if (!is_detected) return EdgeClass::none;
  return edge_class({&maps.depth, &maps.normal, &maps.object_id}, lens, x, y, reach);
}

Detected by_mitchell(const DetectorMaps& maps, const Settings& settings, const LensBlock& lens, int x,
                     int y) {
  const MitchellTerms terms =
      mitchell_terms({{&maps.depth, &maps.normal, &maps.object_id}, &maps.albedo}, x, y);
  const double strength = terms.strength(settings.mitchell), weak = settings.edges.weak;
  if (terms.is_material(settings.mitchell, weak)) return {strength, EdgeClass::material};
  return {strength, class_where(strength >= weak, maps, lens, x, y, 1)};
}

Texture detected_by_method(const DetectorMaps& maps, const Settings& settings, const LensBlock& lens,
                           const GBuffer& gbuffer) {
  const GeneratedSources generated = generated_sources();
  const float weak = settings.edges.weak;
  const Texture& both = gbuffer.normal_and_depth;
  switch (settings.edges.method) {
    case EdgeMethod::decaudin:
      return DecaudinPass(generated).run(settings.decaudin, weak, DecaudinGradientPass(generated).run(both));
    case EdgeMethod::saito_takahashi: {
      const Texture range = VisibleRangePass(generated).run(
          lens.far, whole_image({both.width_px(), both.height_px(), Precision::float32}), gbuffer);
      const Texture visible = VisibleDepthPass(generated).run(lens, both, range);
      return SaitoTakahashiPass(generated).run(settings.saito_takahashi, weak, visible);
    }
    case EdgeMethod::mitchell:
      return MitchellPass(generated).run(settings.mitchell, weak, both, gbuffer, to_texture(maps.albedo));
    default:
      return LaplacianPass(generated).run(settings.laplacian, weak, lens, both);
  }
}

}  // namespace

Image with_classes(const Texture& detection, float weak, const LensBlock& lens, const GBuffer& gbuffer) {
  const GeneratedSources generated = generated_sources();
  const Texture tiles = EdgeTilesPass(generated).run(weak, detection);
  const Image classes =
      EdgeClassPass(generated).run(lens, detection, tiles, gbuffer.normal_and_depth, gbuffer).read(0, 1);
  Image both = detection.read(0, 2);
  for (size_t i = 0; i < classes.samples.size(); ++i) both.samples[2 * i + 1] = classes.samples[i];
  return both;
}

DetectorMaps noisy_maps(int width_px, int height_px, int models, const LensBlock& lens) {
  DetectorMaps maps{noise(width_px, height_px, 1, 11, 0.05F, 0.95F),
                    noise(width_px, height_px, 3, 12),
                    noise(width_px, height_px, 1, 13),
                    noise(width_px, height_px, 4, 14),
                    {}};
  for (size_t i = 0; i < maps.depth.samples.size(); ++i) {
    float& id = maps.object_id.samples[i];
    const bool is_surface = id < 0.85F;
    id = is_surface ? std::floor(id / 0.85F * static_cast<float>(models)) + 1.0F : 0.0F;
    if (!is_surface) maps.depth.samples[i] = 1.0F;
    glm::vec3 n = 2.0F * glm::vec3(maps.normal.samples[3 * i], maps.normal.samples[3 * i + 1],
                                   maps.normal.samples[3 * i + 2]) -
                  1.0F;
    n = is_surface ? glm::normalize(n) : glm::vec3(0.0F);
    for (int c = 0; c < 3; ++c) maps.normal.samples[3 * i + c] = 0.5F * n[c] + 0.5F;
  }
  maps.visible_depth = visible_depth_of(maps.depth, lens);
  return maps;
}

DetectorMaps maps_of(const Frame& frame) {
  DetectorMaps maps{
      frame.raw(BufferName::depth), frame.raw(BufferName::normal), frame.raw(BufferName::object_id), {}, {}};
  const Image colour = frame.raw(BufferName::albedo);
  maps.albedo = Image(colour.width_px, colour.height_px, 4);
  for (size_t i = 0; i < colour.samples.size(); ++i)
    maps.albedo.samples[i / 3 * 4 + i % 3] = colour.samples[i];
  const Settings& settings = frame.settings();
  maps.visible_depth = visible_depth_of(maps.depth, lens_of(settings.camera, settings.image.height));
  return maps;
}

Detected detected_at(const DetectorMaps& maps, const Settings& settings, const LensBlock& lens, int x,
                     int y) {
  const double weak = settings.edges.weak;
  if (settings.edges.method == EdgeMethod::mitchell) return by_mitchell(maps, settings, lens, x, y);
  double strength = 0;
  int reach = 1;
  if (settings.edges.method == EdgeMethod::decaudin) {
    strength = decaudin_terms(maps.depth, maps.normal, settings.decaudin, x, y).strength();
    reach = 2;
  } else if (settings.edges.method == EdgeMethod::saito_takahashi) {
    strength = saito_takahashi_terms(maps.visible_depth, x, y).strength(settings.saito_takahashi);
  } else {
    strength = laplacian_term(maps.depth, lens, x, y).bend / settings.laplacian.bend;
  }
  return {strength, class_where(strength >= weak, maps, lens, x, y, reach)};
}

Image detection_of(const DetectorMaps& maps, const Settings& settings, const LensBlock& lens) {
  const GBuffer gbuffer{to_texture(with_depth(maps.normal, maps.depth)), to_texture(maps.object_id)};
  return with_classes(detected_by_method(maps, settings, lens, gbuffer), settings.edges.weak, lens, gbuffer);
}

std::vector<EdgeMethod> other_methods() {
  return {EdgeMethod::decaudin, EdgeMethod::saito_takahashi, EdgeMethod::mitchell, EdgeMethod::laplacian};
}

std::string name_of_method(EdgeMethod method) {
  return std::string(ChoiceNames<EdgeMethod>::names[static_cast<size_t>(method)]);
}

testing::AssertionResult equals_equations(const Image& detection, const DetectorMaps& maps,
                                          const Settings& settings, const LensBlock& lens,
                                          double other_classes) {
  int classified = 0, others = 0;
  for (int y = 0; y < detection.height_px; ++y) {
    for (int x = 0; x < detection.width_px; ++x) {
      const Detected expected = detected_at(maps, settings, lens, x, y);
      const double strength = detection.at(x, y, 0);
      if (!(std::abs(strength - expected.strength) <= 2e-4 * std::max(1.0, expected.strength))) {
        return testing::AssertionFailure() << fmt::format("at {}, {} the strength is {} instead of {}", x, y,
                                                          strength, expected.strength);
      }
      if (std::abs(expected.strength - settings.edges.weak) < 1e-3) continue;
      classified += expected.of != EdgeClass::none;
      others += detection.at(x, y, 1) != static_cast<float>(expected.of);
    }
  }
  if (others <= other_classes * classified) return testing::AssertionSuccess();
  return testing::AssertionFailure() << fmt::format("{} of {} classes are others", others, classified);
}

}  // namespace inkbench
