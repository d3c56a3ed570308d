// SPDX-License-Identifier: MIT
// What the tests of edge detectors share: maps to try, a detector run on them by OpenGL, and the same by its
// equations.
#pragma once

#include <vector>

#include "pipeline/passes/edges/edge_class.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/pipeline.h"
#include "tests/gl/checks.h"

namespace inkbench {

/// Raw maps of one image, as the G-buffer has them.
struct DetectorMaps {
  Image depth, normal, object_id;
  Image albedo;         ///< H x W x 4: colour, number of the material.
  Image visible_depth;  ///< By its equation, of the depth map.
};

/// Any depth from 0.05 to 0.95, any normal, one model or three, and here and there none.
DetectorMaps noisy_maps(int width_px, int height_px, int models, const LensBlock& lens);

/// The buffers of a frame.
DetectorMaps maps_of(const Frame& frame);

/// Strength and class of one pixel.
struct Detected {
  double strength = 0;
  EdgeClass of = EdgeClass::none;
};

/// By the method's equations, beside the GPU; not the paper's.
Detected detected_at(const DetectorMaps& maps, const Settings& settings, const LensBlock& lens, int x, int y);

/// By OpenGL: H x W x 2.
Image detection_of(const DetectorMaps& maps, const Settings& settings, const LensBlock& lens);

/// The same of a detection whose classes surfaces tell.
Image with_classes(const Texture& detection, float weak, const LensBlock& lens, const GBuffer& gbuffer);

/// The methods that are neither the paper's nor `dihedral`.
std::vector<EdgeMethod> other_methods();

std::string name_of_method(EdgeMethod method);

/// Whether strengths are equal but for rounding, and classes but for a share of those pixels that have one.
testing::AssertionResult equals_equations(const Image& detection, const DetectorMaps& maps,
                                          const Settings& settings, const LensBlock& lens,
                                          double other_classes);

}  // namespace inkbench
