// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/laplacian_detector.h"

#include "pipeline/passes/edges/explained_terms.h"
#include "pipeline/passes/edges/paper_sum.h"

namespace inkbench {
namespace {

/// Of a step from or to where no model is, in an orthographic view: it has no distance.
constexpr double kEndless = 1000;
constexpr int kLaplacianReach = 1;
constexpr std::array<Offset, 4> kDirections{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};

double slope_change(const Image& depth, const LensBlock& lens, int x, int y, Offset to) {
  if (!is_inside_image(depth, x + to.dx, y + to.dy) || !is_inside_image(depth, x - to.dx, y - to.dy))
    return 0;
  const double before = depth.at(x - to.dx, y - to.dy), after = depth.at(x + to.dx, y + to.dy);
  if (lens.is_orthographic != 0 && (is_background(before) || is_background(after))) return kEndless;
  const double here = affine_depth(lens, depth.at(x, y));
  return in_pixel_sizes(lens, affine_depth(lens, before) + affine_depth(lens, after) - 2 * here, here);
}

class LaplacianDetector final : public EdgeDetector {
 public:
  std::string_view name() const override { return "laplacian"; }
  std::string_view help() const override {
    return "The second difference of 1/z in units of slope: none on planes, however slanted.";
  }
  std::vector<BufferName> maps() const override { return {BufferName::depth, BufferName::object_id}; }
  int reach_px() const override { return kLaplacianReach + 1; }

  Explanation explain(const PerBuffer<Image>& maps, const Settings& settings, int x, int y) const override {
    using Role = ExplainedInput::Role;
    const Image& depth = maps[BufferName::depth];
    const SurfaceMaps surfaces{&depth, nullptr, &maps[BufferName::object_id]};
    const LensBlock lens = lens_of(settings.camera, settings.image.height);
    const LaplacianTerm found = laplacian_term(depth, lens, x, y);
    ExplainedTerm term{
        .name = "bend", .title = "Change of slope", .value = found.bend, .limit = settings.laplacian.bend};
    term.around = values_around(depth, x, y);
    term.inputs = {{"depth", depth.at(x, y), "of far", Role::plain, {}}};
    if (found.bend > 0) {
      for (const Offset at : {Offset{-found.at.dx, -found.at.dy}, found.at})
        term.inputs.push_back({"depth", depth.at(x + at.dx, y + at.dy), "of far", Role::plain, at});
      const std::optional<GradientStep> step = largest_step(surfaces, depth, x, y);
      if (step) term.cause = cause_text(*step, true, model_names(settings));
    }
    const double strength = found.bend / settings.laplacian.bend;
    return explained_by_largest(name(), {std::move(term)}, strength, settings.edges.weak,
                                edge_class(surfaces, lens, x, y, kLaplacianReach));
  }

  std::vector<std::string> deciding_parameters() const override { return {"laplacian.bend"}; }
  bool has_normal_term(const Settings&) const override { return false; }
  bool sees_facets(const Settings&) const override { return true; }
  bool tells_objects(const Settings&) const override { return false; }
  std::optional<Settings> without_depth_term(const Settings&) const override {
    return std::nullopt;  // the depth's slope makes no line
  }
};

}  // namespace

LaplacianTerm laplacian_term(const Image& depth, const LensBlock& lens, int x, int y) {
  LaplacianTerm term;
  if (is_background(depth.at(x, y))) return term;
  for (const Offset& to : kDirections) {
    const double bend = slope_change(depth, lens, x, y, to);
    if (bend > term.bend) term = {bend, to};
  }
  return term;
}

const EdgeDetector& laplacian_detector() {
  static const LaplacianDetector kDetector;
  return kDetector;
}

}  // namespace inkbench
