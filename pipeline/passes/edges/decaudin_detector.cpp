// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/decaudin_detector.h"

#include <algorithm>

#include "pipeline/passes/edges/explained_terms.h"
#include "pipeline/passes/edges/paper_sum.h"

namespace inkbench {
namespace {

/// The range looks at gradients one pixel away, and those at maps one more.
constexpr int kDecaudinReach = 2;

DecaudinTerm decaudin_term(const Image& map, int channel, double k, int x, int y) {
  DecaudinTerm term{.channel = channel};
  for (int i = 0; i < 9; ++i) {
    const int gx = x + i % 3 - 1, gy = y + i / 3 - 1;
    if (is_inside_image(map, gx, gy))
      term.around[static_cast<size_t>(i)] = static_cast<float>(first_order(map, gx, gy, channel));
  }
  term.range = range_of(term.around);
  term.ratio = (term.range.largest - term.range.smallest) / k;
  return term;
}

ExplainedTerm explained_ratio(std::string name, std::string title, const DecaudinTerm& term, double k) {
  using Role = ExplainedInput::Role;
  ExplainedTerm result{
      .name = std::move(name), .title = std::move(title), .value = term.ratio * term.ratio, .limit = 0.5};
  result.inputs = {{"gmax", term.range.largest, "", Role::largest, term.range.largest_at},
                   {"gmin", term.range.smallest, "", Role::smallest, term.range.smallest_at},
                   {"k", k, "", Role::plain, {}},
                   {"ratio", term.ratio, "", Role::plain, {}},
                   {"p", std::min(term.ratio * term.ratio, 1.0), "", Role::plain, {}}};
  result.around = term.around;
  return result;
}

/// What lies on both sides where the largest gradient is.
std::string decaudin_cause(const DecaudinTerm& term, const SurfaceMaps& maps, const Image& map, bool is_depth,
                           int x, int y, const Settings& settings) {
  const std::optional<GradientStep> step =
      largest_step(maps, map, x + term.range.largest_at.dx, y + term.range.largest_at.dy);
  return step && term.ratio > 0 ? cause_text(*step, is_depth, model_names(settings)) : "";
}

class DecaudinDetector final : public EdgeDetector {
 public:
  std::string_view name() const override { return "decaudin"; }
  std::string_view help() const override {
    return "Decaudin's: the ranges of the depth's and of each normal component's gradients, the largest of "
           "which is the ink.";
  }
  std::vector<BufferName> maps() const override {
    return {BufferName::depth, BufferName::normal, BufferName::object_id};
  }
  int reach_px() const override { return kDecaudinReach + 1; }

  Explanation explain(const PerBuffer<Image>& maps, const Settings& settings, int x, int y) const override {
    const Image& depth = maps[BufferName::depth];
    const Image& normal = maps[BufferName::normal];
    const SurfaceMaps surfaces{&depth, &normal, &maps[BufferName::object_id]};
    const DecaudinParams& params = settings.decaudin;
    const DecaudinTerms found = decaudin_terms(depth, normal, params, x, y);
    std::vector<ExplainedTerm> terms{
        explained_ratio("depth", "Squared ratio of the depth", found.depth, params.k_depth),
        explained_ratio("normal", std::string("Squared ratio of the normal's ") + "xyz"[found.normal.channel],
                        found.normal, params.k_normal)};
    terms[0].cause = decaudin_cause(found.depth, surfaces, depth, true, x, y, settings);
    terms[1].cause = decaudin_cause(found.normal, surfaces, normal, false, x, y, settings);
    const LensBlock lens = lens_of(settings.camera, settings.image.height);
    return explained_by_largest(name(), std::move(terms), found.strength(), settings.edges.weak,
                                edge_class(surfaces, lens, x, y, kDecaudinReach));
  }

  std::vector<std::string> deciding_parameters() const override {
    return {"decaudin.k_depth", "decaudin.k_normal"};
  }
  bool has_normal_term(const Settings&) const override { return true; }
  bool tells_objects(const Settings&) const override { return false; }
  std::optional<Settings> without_depth_term(const Settings& settings) const override {
    Settings without = settings;
    without.decaudin.k_depth = 1;  // a step has no more than half of the whole depth
    return without;
  }
};

}  // namespace

double DecaudinTerms::strength() const {
  const double ratio = std::max(depth.ratio, normal.ratio);
  return 2 * ratio * ratio;
}

DecaudinTerms decaudin_terms(const Image& depth, const Image& normal, const DecaudinParams& params, int x,
                             int y) {
  DecaudinTerms terms{decaudin_term(depth, 0, params.k_depth, x, y),
                      decaudin_term(normal, 0, params.k_normal, x, y)};
  for (int c = 1; c < 3; ++c) {
    const DecaudinTerm other = decaudin_term(normal, c, params.k_normal, x, y);
    if (other.ratio > terms.normal.ratio) terms.normal = other;
  }
  return terms;
}

const EdgeDetector& decaudin_detector() {
  static const DecaudinDetector kDetector;
  return kDetector;
}

}  // namespace inkbench
