// SPDX-License-Identifier: MIT
#include "studies/judging/cause_finder.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "pipeline/base/error.h"
#include "pipeline/gl/context.h"
#include "pipeline/passes/edges/edge_detector.h"
#include "pipeline/passes/lines/reference.h"
#include "studies/judging/measured_lines.h"
#include "studies/measures/distance.h"
#include "studies/measures/matching.h"

namespace inkbench {
namespace {

/// Whether the model's own normals are read: flat and smooth levels have others.
bool has_own_normals(const Settings& settings, size_t model) {
  const LevelNormals level = level_of(settings, model).normals;
  return level != LevelNormals::flat && level != LevelNormals::smooth;
}

/// One normal a vertex on every mesh whose vertices may be split; nothing where none may. Flat faces have
/// normals of their own, and so have built-in shapes.
std::optional<Settings> with_smooth_normals(const Settings& settings) {
  Settings smooth = settings;
  bool changes = false;
  for (size_t i = 0; i < smooth.models.size(); ++i) {
    ModelParams& model = smooth.models[i];
    const bool may_be_split = model.normals == ModelNormals::file || model.normals == ModelNormals::crease;
    if (!model.visible || model.shape != Shape::mesh || !may_be_split || !has_own_normals(settings, i))
      continue;
    model.normals = ModelNormals::smooth;
    changes = true;
  }
  return changes ? std::optional(smooth) : std::nullopt;
}

/// Smooth normals where they are flat; nothing where none are.
std::optional<Settings> without_flat_normals(const Settings& settings) {
  Settings smooth = settings;
  bool changes = smooth.mesh.normals == LevelNormals::flat;
  if (changes) smooth.mesh.normals = LevelNormals::smooth;
  for (ModelParams& model : smooth.models) {
    if (!model.visible || model.normals != ModelNormals::flat) continue;
    model.normals = ModelNormals::smooth;
    changes = true;
  }
  return changes ? std::optional(smooth) : std::nullopt;
}

/// Edges that bend less are rounding's.
constexpr float kSlightBendDegrees = 2.0F;

Settings twice_as_large(const Settings& settings) {
  Settings large = settings;
  large.image.width *= 2;
  large.image.height *= 2;
  const int most = renderer_info().max_side_px;
  if (std::max(large.image.width, large.image.height) <= most) return large;
  throw input_error(
      "causes",
      fmt::format("are found by drawing at twice the size, {} x {} px, too large for this renderer",
                  large.image.width, large.image.height),
      fmt::format("choose an image of at most {0} x {0} px", most / 2));
}

Settings with_float_buffers(const Settings& settings) {
  Settings precise = settings;
  precise.image.precision = Precision::float32;
  return precise;
}

}  // namespace

CauseFinder::CauseFinder(Pipeline& pipeline, const Settings& settings, FindLines find_lines)
    : pipeline_(pipeline), settings_(settings), find_lines_(std::move(find_lines)) {
  if (!find_lines_) {
    find_lines_ = [&pipeline](const LineRequest& request) {
      return std::make_shared<const ReferenceLines>(pipeline.line_finder()->find(request));
    };
  }
  plan();
}

std::shared_ptr<const ReferenceLines> CauseFinder::find(const std::function<LineRequest()>& make) {
  if (!asked_) asked_ = make();
  const std::shared_ptr<const ReferenceLines> lines = find_lines_(*asked_);
  if (lines) asked_.reset();
  return lines;
}

/// The drawing itself, and what its own buffers say.
bool CauseFinder::judge_drawing() {
  const Frame frame = pipeline_.at(settings_);
  const std::shared_ptr<const ReferenceLines> lines = find([&] { return frame.line_request(); });
  if (!lines) return false;
  const EdgeDetector& detector = edge_detector(settings_);
  evidence_.drawn = line_map_from(frame.raw(BufferName::lines));
  const LineView view = line_view(evidence_.drawn, *lines, settings_.judge);
  evidence_.maps = match_maps(view, settings_.judge.tolerance);
  evidence_.reference = united(view.wanted, view.allowed);
  evidence_.objects = class_map(*lines, LineClass::object);
  evidence_.strength = frame.raw(BufferName::edge_strength);
  evidence_.tells_objects = detector.tells_objects(settings_);
  evidence_.tolerance_px = settings_.judge.tolerance;
  is_judged_ = true;
  return true;
}

/// Of the meshes as they are drawn, where the reference's creases are the full ones'.
bool CauseFinder::find_slight_bends() {
  const auto lines = find([&] {
    Settings slight = settings_;
    slight.judge.crease_angle = std::min(kSlightBendDegrees, settings_.judge.crease_angle);
    LineRequest request = pipeline_.at(slight).line_request();
    request.key = KeyBuilder().add("bends of what is drawn").add(request.key).key();
    for (LineModel& model : request.models) {
      model.full = model.drawn;
      model.full_key = KeyBuilder().add(model.full_key).add(model.drawn_key).key();
    }
    return request;
  });
  if (lines) evidence_.slight_bends = class_map(*lines, LineClass::crease);
  return lines != nullptr;
}

void CauseFinder::add(Lines map, const Settings& settings) {
  steps_.push_back([this, map, settings] {
    evidence_.*map = line_map_from(pipeline_.at(settings).raw(BufferName::lines));
    return true;
  });
}

void CauseFinder::plan_facets() {
  const EdgeDetector& detector = edge_detector(settings_);
  if (!detector.sees_facets(settings_)) return;
  steps_.push_back([this] { return find_slight_bends(); });
  const std::optional<Settings> unfaceted = without_flat_normals(settings_);
  if (unfaceted && detector.has_normal_term(settings_)) add(&CauseEvidence::unfaceted, *unfaceted);
  evidence_.reads_surface = detector.sees_facets(unfaceted.value_or(settings_));
}

void CauseFinder::plan() {
  const EdgeDetector& detector = edge_detector(settings_);
  const Settings large = twice_as_large(settings_);
  steps_.push_back([this] { return judge_drawing(); });
  plan_facets();
  if (settings_.image.precision != Precision::float32)
    add(&CauseEvidence::float_buffers, with_float_buffers(settings_));
  if (const auto smooth = with_smooth_normals(settings_); smooth && detector.has_normal_term(settings_))
    add(&CauseEvidence::smooth_normals, *smooth);
  if (const auto flat = detector.without_depth_term(settings_)) {
    add(&CauseEvidence::no_depth_term, *flat);
    steps_.push_back([this, reach_px = detector.reach_px()] {
      const Frame precise = pipeline_.at(with_float_buffers(settings_));
      evidence_.even = even_pixels(precise.raw(BufferName::depth), settings_.camera, reach_px);
      return true;
    });
  }
  add(&CauseEvidence::twice_as_large, large);
}

bool CauseFinder::step() {
  if (!steps_.empty() && steps_.front()()) steps_.pop_front();
  return !steps_.empty();
}

CauseMaps find_causes(Pipeline& pipeline, const Settings& settings) {
  CauseFinder finder(pipeline, settings);
  while (finder.step()) {
  }
  return finder.causes();
}

std::optional<PixelCause> find_cause(Pipeline& pipeline, const Settings& settings, int x, int y) {
  CauseFinder finder(pipeline, settings);
  finder.step();
  const double tolerance_px = settings.judge.tolerance;
  const LineMap wrong = united(finder.maps()->wrong, finder.maps()->missed);
  const std::vector<Pixel> pixel{{x, y}};
  const int64_t distance = squared_distances(pixel, wrong).front();
  if (distance == kInfinitelyFar || distance > squared_tolerance(tolerance_px)) return std::nullopt;
  while (finder.step()) {
  }
  return cause_near(finder.causes(), x, y, tolerance_px);
}

Key causes_key(const Frame& frame) {
  KeyBuilder builder;
  builder.add("causes");
  builder.add(judge_text(frame.settings().judge));
  for (const Key& key : frame.pass_keys()) builder.add(key);
  return builder.key();
}

}  // namespace inkbench
