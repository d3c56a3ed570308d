// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/saito_takahashi_detector.h"

#include <algorithm>

#include "pipeline/passes/edges/explained_terms.h"
#include "pipeline/passes/edges/paper_sum.h"

namespace inkbench {
namespace {

/// A crease draws no more than twice its limit says.
constexpr double kMostOfACrease = 2;
/// Of the farthest distance: what is visible lies at one distance but for rounding.
constexpr double kNoRange = 1e-4;
/// Where no model is, if 1 / distance = 0 does not say it.
constexpr double kBeyond = 2;

constexpr int kSaitoTakahashiReach = 1;

class SaitoTakahashiDetector final : public EdgeDetector {
 public:
  std::string_view name() const override { return "saito_takahashi"; }
  std::string_view help() const override {
    return "Saito and Takahashi's: profiles by the first difference of the visible depth, creases by the "
           "second.";
  }
  std::vector<BufferName> maps() const override {
    return {BufferName::visible_depth, BufferName::depth, BufferName::object_id};
  }
  /// The operator of a pixel of the image's border is that of the next one inside; so is the class's reach.
  int reach_px() const override { return kSaitoTakahashiReach + 1; }

  Explanation explain(const PerBuffer<Image>& maps, const Settings& settings, int x, int y) const override {
    using Role = ExplainedInput::Role;
    const Image& visible = maps[BufferName::visible_depth];
    const SurfaceMaps surfaces{&maps[BufferName::depth], nullptr, &maps[BufferName::object_id]};
    const SaitoTakahashiParams& params = settings.saito_takahashi;
    const SaitoTakahashiTerms found = saito_takahashi_terms(visible, x, y);
    const auto around = values_around(visible, x, y);
    const RangeAround range = range_of(around);
    std::vector<ExplainedTerm> terms{
        {.name = "profile", .title = "First difference", .value = found.profile, .limit = params.profile},
        {.name = "crease", .title = "Second difference", .value = found.crease, .limit = params.crease}};
    for (ExplainedTerm& term : terms) {
      term.unit = "of the visible depth";
      term.inputs = {{"visible depth", visible.at(x, y), "", Role::plain, {}},
                     {"largest around", range.largest, "", Role::largest, range.largest_at},
                     {"smallest around", range.smallest, "", Role::smallest, range.smallest_at}};
      term.around = around;
      const std::optional<GradientStep> step = largest_step(surfaces, *surfaces.depth, x, y);
      if (step && term.value > 0) term.cause = cause_text(*step, true, model_names(settings));
    }
    const LensBlock lens = lens_of(settings.camera, settings.image.height);
    return explained_by_largest(name(), std::move(terms), found.strength(params), settings.edges.weak,
                                edge_class(surfaces, lens, x, y, kSaitoTakahashiReach));
  }

  std::vector<std::string> deciding_parameters() const override {
    return {"saito_takahashi.profile", "saito_takahashi.crease"};
  }
  bool has_normal_term(const Settings&) const override { return false; }
  bool sees_facets(const Settings&) const override { return true; }  // by the second difference
  bool tells_objects(const Settings&) const override { return false; }
  std::optional<Settings> without_depth_term(const Settings& settings) const override {
    Settings without = settings;
    without.saito_takahashi.profile = 10;  // a step between surfaces has no more than a half
    return without;
  }
};

}  // namespace

double visible_depth(const LensBlock& lens, double nearest, double farthest, double depth) {
  const bool is_orthographic = lens.is_orthographic != 0;
  const bool has_range = farthest - nearest > kNoRange * farthest;
  if (is_background(depth)) return has_range && !is_orthographic ? farthest / (farthest - nearest) : kBeyond;
  if (!has_range) return 0;
  const double z = std::clamp(depth * lens.far, nearest, farthest);  // eight bits round out of the range
  return is_orthographic ? (z - nearest) / (farthest - nearest)
                         : (1 / z - 1 / nearest) / (1 / farthest - 1 / nearest);
}

double SaitoTakahashiTerms::strength(const SaitoTakahashiParams& params) const {
  return std::max(profile / params.profile, std::min(crease / params.crease, kMostOfACrease));
}

SaitoTakahashiTerms saito_takahashi_terms(const Image& visible_depth, int x, int y) {
  return {first_order(visible_depth, x, y), second_order(visible_depth, x, y)};
}

const EdgeDetector& saito_takahashi_detector() {
  static const SaitoTakahashiDetector kDetector;
  return kDetector;
}

}  // namespace inkbench
