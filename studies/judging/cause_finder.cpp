// SPDX-License-Identifier: MIT
#include "studies/judging/cause_finder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/passes/edges/edge_detector.h"
#include "pipeline/passes/lines/reference.h"
#include "studies/judging/measured_lines.h"

namespace inkbench {
namespace {

/// One normal a vertex on every model whose normals may be split; none where that changes nothing.
std::optional<Settings> with_smooth_normals(const Settings& settings) {
  Settings smooth = settings;
  bool changes = false;
  for (ModelParams& model : smooth.models) {
    // Flat faces have their own normals: nothing is split there.
    if (model.shape != Shape::mesh || model.normals == ModelNormals::flat) continue;
    changes = changes || model.normals != ModelNormals::smooth;
    model.normals = ModelNormals::smooth;
  }
  const bool is_flat_level = settings.mesh.normals == LevelNormals::flat;
  return changes && !is_flat_level ? std::optional(smooth) : std::nullopt;
}

/// Edges that bend less count from here on: what even a flat face's neighbours differ by through rounding.
constexpr float kSlightBendDegrees = 2.0F;

Settings with_slight_creases(const Settings& settings) {
  Settings slight = settings;
  slight.judge.crease_angle = std::min(kSlightBendDegrees, settings.judge.crease_angle);
  return slight;
}

Settings twice_as_large(const Settings& settings) {
  Settings large = settings;
  large.image.width *= 2;
  large.image.height *= 2;
  return large;
}

/// 1 / distance, 0 where no model is; orthographic: the distance.
double affine_depth(float depth, const CameraParams& camera) {
  const double distance = static_cast<double>(depth) * camera.far;
  if (is_orthographic(camera)) return distance;
  return depth >= 1.0F ? 0.0 : 1.0 / distance;
}

/// The smaller one of the differences to both neighbours along an axis.
double flatter_slope(double before, double here, double after) {
  const double back = here - before, forth = after - here;
  return std::abs(back) < std::abs(forth) ? back : forth;
}

}  // namespace

LineMap even_pixels(const Image& depth, const CameraParams& camera, int reach_px) {
  LineMap even(depth.width_px, depth.height_px);
  const double delta = pixel_size(camera, 1.0, depth.height_px);
  const auto at = [&](int x, int y) {
    return affine_depth(depth.at(std::clamp(x, 0, depth.width_px - 1), std::clamp(y, 0, depth.height_px - 1)),
                        camera);
  };
  for (int y = 0; y < depth.height_px; ++y) {
    for (int x = 0; x < depth.width_px; ++x) {
      if (depth.at(x, y) >= 1.0F) continue;
      const double here = at(x, y), unit = is_orthographic(camera) ? delta : here * delta;
      const double slope_x = flatter_slope(at(x - 1, y), here, at(x + 1, y));
      const double slope_y = flatter_slope(at(x, y - 1), here, at(x, y + 1));
      const double slant = std::sqrt(1.0 + (slope_x * slope_x + slope_y * slope_y) / (unit * unit));
      double farthest = 0;
      for (int dy = -reach_px; dy <= reach_px; ++dy) {
        for (int dx = -reach_px; dx <= reach_px; ++dx) {
          const bool is_inside =
              x + dx >= 0 && y + dy >= 0 && x + dx < depth.width_px && y + dy < depth.height_px;
          if (!is_inside) continue;
          const double off = at(x + dx, y + dy) - here - dx * slope_x - dy * slope_y;
          farthest = std::max(farthest, std::abs(off) / unit / slant);
        }
      }
      even.set(x, y, farthest <= 1.0);
    }
  }
  return even;
}

CauseFinder::CauseFinder(Pipeline& pipeline, const Settings& settings)
    : pipeline_(pipeline), settings_(settings) {
  plan();
}

LineMap CauseFinder::lines_of(const Settings& settings) {
  return line_map_from(pipeline_.at(settings).raw(BufferName::lines));
}

/// The drawing itself, and what its own buffers say.
void CauseFinder::judge_drawing() {
  const Frame frame = pipeline_.at(settings_);
  const EdgeDetector& detector = edge_detector(settings_);
  const auto lines = frame.value<ReferencePass>();
  evidence_.drawn = line_map_from(frame.raw(BufferName::lines));
  const LineView view = line_view(evidence_.drawn, *lines, settings_.judge);
  evidence_.maps = match_maps(view, settings_.judge.tolerance);
  evidence_.reference = united(view.wanted, view.allowed);
  evidence_.objects = class_map(*lines, LineClass::object);
  evidence_.strength = frame.raw(BufferName::edge_strength);
  evidence_.tells_objects = detector.tells_objects(settings_);
  evidence_.tolerance_px = settings_.judge.tolerance;
  if (detector.without_depth_term(settings_)) {
    Settings precise = settings_;
    precise.image.precision = Precision::float32;
    evidence_.even =
        even_pixels(pipeline_.at(precise).raw(BufferName::depth), settings_.camera, detector.reach_px());
  }
}

void CauseFinder::plan() {
  const EdgeDetector& detector = edge_detector(settings_);
  const auto add = [&](std::optional<LineMap> CauseEvidence::*map, const Settings& settings) {
    steps_.push_back([this, map, settings] { evidence_.*map = lines_of(settings); });
  };
  if (settings_.image.precision != Precision::float32) {
    Settings precise = settings_;
    precise.image.precision = Precision::float32;
    add(&CauseEvidence::float_buffers, precise);
  }
  if (detector.has_normal_term(settings_)) {
    if (const auto smooth = with_smooth_normals(settings_)) add(&CauseEvidence::smooth_normals, *smooth);
  }
  if (detector.sees_facets(settings_)) {
    steps_.push_back([this] {
      const Frame slight = pipeline_.at(with_slight_creases(settings_));
      evidence_.slight_bends = class_map(*slight.value<ReferencePass>(), LineClass::crease);
    });
  }
  if (const auto flat = detector.without_depth_term(settings_)) add(&CauseEvidence::no_depth_term, *flat);
  add(&CauseEvidence::twice_as_large, twice_as_large(settings_));
  // Last of all, so that what the pipeline holds in the end is the drawing.
  steps_.push_back([this] { judge_drawing(); });
  std::reverse(steps_.begin(), steps_.end());
}

bool CauseFinder::step() {
  if (steps_.empty()) return false;
  const std::function<void()> next = std::move(steps_.back());
  steps_.pop_back();
  next();
  return !steps_.empty();
}

CauseMaps find_causes(Pipeline& pipeline, const Settings& settings) {
  CauseFinder finder(pipeline, settings);
  while (finder.step()) {
  }
  return finder.causes();
}

}  // namespace inkbench
