// SPDX-License-Identifier: MIT
// The detectors other than the paper's and `dihedral`: OpenGL against their equations, on noise and on
// scenes, and what they answer on scenes that have a closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "pipeline/explain.h"
#include "tests/gl/detector_support.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

/// Limits of which noise passes some and not others.
Settings noisy_settings(EdgeMethod method) {
  Settings settings;
  settings.edges = {.method = method, .weak = 0.5F};
  settings.decaudin = {.k_depth = 0.3F, .k_normal = 0.4F};
  settings.saito_takahashi = {.profile = 0.5F, .crease = 1.5F};
  settings.mitchell = {.angle = 170.0F, .depth = 0.8F, .use_ids = false, .albedo = 0.9F};
  settings.laplacian.bend = 3000.0F;
  return settings;
}

TEST(Detectors, equal_their_equations_on_noise_of_any_size) {
  for (const int is_orthographic : {0, 1}) {
    const LensBlock lens{7.0F, 0.002F, is_orthographic, 0};
    for (const EdgeMethod method : other_methods()) {
      const Settings settings = noisy_settings(method);
      for (const auto& [width, height, models] :
           {std::tuple{1, 1, 1}, {2, 3, 1}, {3, 1, 1}, {97, 61, 1}, {40, 30, 3}}) {
        const DetectorMaps maps = noisy_maps(width, height, models, lens);
        EXPECT_TRUE(equals_equations(detection_of(maps, settings, lens), maps, settings, lens, 0.0))
            << name_of_method(method) << " " << width << " x " << height << " " << is_orthographic;
      }
    }
  }
}

/// The frame's detection, H x W x 2.
Image frame_detection(const Frame& frame) {
  const Image strength = frame.raw(BufferName::edge_strength), of = frame.raw(BufferName::edge_class);
  Image both(strength.width_px, strength.height_px, 2);
  for (size_t i = 0; i < strength.samples.size(); ++i) {
    both.samples[2 * i] = strength.samples[i];
    both.samples[2 * i + 1] = of.samples[i];
  }
  return both;
}

TEST(Detectors, equal_their_equations_on_a_scene_also_in_eight_bits_and_orthographic) {
  Settings settings = analytic_scene();
  settings.edges.weak = 0.6F;
  Pipeline pipeline;
  for (const auto& [precision, projection] : {std::pair{Precision::float32, CameraProjection::perspective},
                                              {Precision::unorm8, CameraProjection::perspective},
                                              {Precision::float32, CameraProjection::orthographic}}) {
    settings.image.precision = precision;
    settings.camera.projection = projection;
    const LensBlock lens = lens_of(settings.camera, settings.image.height);
    for (const EdgeMethod method : other_methods()) {
      if (precision == Precision::unorm8 && method == EdgeMethod::saito_takahashi)
        continue;  // its range is of floats
      settings.edges.method = method;
      const Frame frame = pipeline.at(settings);
      // Bends and steps that are at the limit but for rounding.
      EXPECT_TRUE(equals_equations(frame_detection(frame), maps_of(frame), settings, lens, 0.002))
          << name_of_method(method);
    }
  }
}

TEST(Detectors, a_class_is_shown_in_its_colour_and_none_in_white) {
  Settings settings = analytic_scene();
  settings.edges.method = EdgeMethod::laplacian;
  Pipeline pipeline;
  const Frame frame = pipeline.at(settings);
  const Image of = frame.raw(BufferName::edge_class);
  const Picture shown = frame.picture(BufferName::edge_class);
  const std::map<float, int> red_of{{0.0F, 255}, {1.0F, 0}, {3.0F, 213}};  // none, object, crease
  std::set<float> seen;
  for (int y = 0; y < of.height_px; ++y) {
    for (int x = 0; x < of.width_px; ++x) {
      const auto red = red_of.find(of.at(x, y));
      if (red == red_of.end()) continue;
      seen.insert(red->first);
      ASSERT_EQ(shown.at(x, y, 0), red->second) << x << ", " << y;
    }
  }
  EXPECT_EQ(seen.size(), red_of.size());
}

TEST(Detectors, explain_says_what_was_detected_at_every_pixel) {
  Settings settings = analytic_scene();
  Pipeline pipeline;
  for (const EdgeMethod method : other_methods()) {
    settings.edges.method = method;
    const Frame frame = pipeline.at(settings);
    const KeptMaps kept = keep_maps(frame);
    const Image of = frame.raw(BufferName::edge_class);
    int lines = 0, other_classes = 0;
    for (int y = 0; y < settings.image.height; y += 4) {
      for (int x = y % 3; x < settings.image.width; x += 2) {
        const Explanation why = explain_pixel(kept, x, y);
        EXPECT_EQ(why.detector, name_of_method(method));
        EXPECT_NEAR(why.edge, why.drawn, 2e-4 * std::max(1.0, why.edge)) << x << ", " << y;
        if (std::abs(why.edge - 1) < 1e-3) continue;
        EXPECT_EQ(why.is_line, why.drawn >= 1) << x << ", " << y;
        other_classes += why.line_class != class_name(static_cast<EdgeClass>(static_cast<int>(of.at(x, y))));
        lines += why.is_line;
      }
    }
    EXPECT_GT(lines, 50) << name_of_method(method);
    EXPECT_LE(other_classes, lines / 200) << name_of_method(method);
    for (const int x : {0, 1, 80, settings.image.width - 1}) {
      for (const int y : {0, 58, settings.image.height - 1})
        EXPECT_EQ(explanation_json(explain_pixel(frame, x, y)), explanation_json(explain_pixel(kept, x, y)));
    }
  }
}

}  // namespace
}  // namespace inkbench
