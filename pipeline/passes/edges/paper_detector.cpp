// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/paper_detector.h"

#include "pipeline/passes/edges/explained_terms.h"
#include "pipeline/passes/edges/paper_sum.h"

namespace inkbench {
namespace {

/// A gradient's neighbour is one pixel away, and the maps that it compares are one more. To tell a step from
/// a bend there takes another.
constexpr int kPaperReach = 2;

ExplainedTerm explained(const char* name, const char* title, const TermWhy& term, const Image& edges, int x,
                        int y, bool is_depth, std::span<const std::string> objects) {
  using Role = ExplainedInput::Role;
  ExplainedTerm result{.name = name, .title = title, .used = term.used, .value = term.p};
  result.inputs = {{"gmax", term.gmax, "", Role::largest, term.max_at},
                   {"gmin", term.gmin, "", Role::smallest, term.min_at},
                   {"k", term.k, "", Role::plain, {}},
                   {"ratio", term.ratio, "", Role::plain, {}}};
  result.around = values_around(edges, x, y);
  if (term.step && term.gmax > term.gmin) result.cause = cause_text(*term.step, is_depth, objects);
  return result;
}

class PaperDetector final : public EdgeDetector {
 public:
  std::string_view name() const override { return "paper"; }
  std::string_view help() const override {
    return "Scheelk's: the ranges of the depth's and the normals' gradients, summed against a threshold.";
  }
  std::vector<BufferName> maps() const override {
    return {BufferName::depth_edges, BufferName::normal_edges, BufferName::depth, BufferName::normal,
            BufferName::object_id};
  }
  int reach_px() const override { return kPaperReach + 1; }
  BufferName decided() const override { return BufferName::combined_edges; }

  Explanation explain(const PerBuffer<Image>& maps, const Settings& settings, int x, int y) const override {
    const Image& depth_edges = maps[BufferName::depth_edges];
    const Image& normal_edges = maps[BufferName::normal_edges];
    const EdgeBuffers buffers{depth_edges, normal_edges, &maps[BufferName::depth], &maps[BufferName::normal],
                              &maps[BufferName::object_id]};
    const PixelWhy why = why_pixel(buffers, settings.combine, x, y, settings.image.precision);
    const std::vector<std::string> objects = model_names(settings);
    const LensBlock lens = lens_of(settings.camera, settings.image.height);
    Explanation result{.detector = std::string(name()), .x = x, .y = y};
    result.terms = {explained("depth", "Depth term", why.depth, depth_edges, x, y, true, objects),
                    explained("normal", "Normal term", why.normal, normal_edges, x, y, false, objects)};
    result.sum = why.sum;
    result.limit = why.threshold;
    result.limit_name = "threshold";
    result.edge = why.edge;
    result.is_line = why.inked;
    if (why.inked) result.line_class = class_name(edge_class(buffers.surfaces(), lens, x, y, kPaperReach));
    result.verdict = verdict_text(why);
    return result;
  }

  std::vector<std::string> deciding_parameters() const override {
    return {"combine.k_depth", "combine.k_normal", "combine.threshold", "combine.use_depth",
            "combine.use_normal"};
  }
  bool has_normal_term(const Settings& settings) const override { return settings.combine.use_normal; }
  bool tells_objects(const Settings&) const override { return false; }
  std::optional<Settings> without_depth_term(const Settings& settings) const override {
    Settings without = settings;
    without.combine.use_depth = false;
    return settings.combine.use_depth ? std::optional(without) : std::nullopt;
  }
};

}  // namespace

const EdgeDetector& paper_detector() {
  static const PaperDetector kDetector;
  return kDetector;
}

}  // namespace inkbench
