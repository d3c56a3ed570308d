// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/dihedral_detector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/passes/edges/dihedral_sides.h"

namespace inkbench {
namespace {

using Sides = std::array<PixelSide, 4>;

/// The side that decides: of the pixel's own ones the strongest, else the strongest of all.
const PixelSide& decisive(const Sides& sides) {
  return *std::max_element(sides.begin(), sides.end(), [](const PixelSide& a, const PixelSide& b) {
    return a.is_own != b.is_own ? b.is_own : a.strength < b.strength;
  });
}

double strength_of(const Sides& sides) {
  double strength = 0;
  for (const PixelSide& side : sides) strength = std::max(strength, side.is_own ? side.strength : 0.0);
  return strength;
}

/// Of the sides that reach `weak`, the first class in the enum's order.
EdgeClass class_of(const Sides& sides, double weak) {
  EdgeClass result = EdgeClass::none;
  for (const PixelSide& side : sides) {
    if (!side.is_own || side.strength < weak) continue;
    if (result == EdgeClass::none || side.line_class < result) result = side.line_class;
  }
  return result;
}

/// What a term looked at on each of the four sides.
ExplainedTerm term_of(const char* name, const char* title, const Sides& sides, double PixelSide::*value,
                      double limit, const char* unit) {
  ExplainedTerm term{.name = name, .title = title, .limit = limit, .unit = unit};
  for (const PixelSide& side : sides) {
    const double measured = side.*value;
    const int place = (side.to.dy + 1) * 3 + side.to.dx + 1;
    term.around[static_cast<size_t>(place)] = static_cast<float>(measured);
    term.inputs.push_back({side.is_own ? "this pixel's" : "the neighbour's", measured, unit,
                           ExplainedInput::Role::plain, side.to});
    if (side.is_own) term.value = std::max(term.value, measured);
  }
  return term;
}

std::string cause_of(const PixelSide& side, const PerBuffer<Image>& maps, const Settings& settings, int x,
                     int y) {
  if (side.is_object_border) {
    const auto name = [&](int id) {
      const bool known = id >= 1 && static_cast<size_t>(id) <= settings.models.size();
      return known ? settings.models[static_cast<size_t>(id) - 1].name : std::string("the background");
    };
    const Image& ids = maps[BufferName::object_id];
    return name(static_cast<int>(ids.at(x, y))) + " ends at " +
           name(static_cast<int>(ids.at(x + side.to.dx, y + side.to.dy)));
  }
  if (side.gap_px > 0.0) return fmt::format("the planes lie {:.3g} px apart", side.gap_px);
  return fmt::format("the planes meet at {:.3g} degrees", side.angle_deg);
}

/// To hundredths, so that a limit of so much is reached.
double rounded_down(double value) {
  return std::floor(value * 100.0) / 100.0;
}

std::string verdict_of(const PixelSide& side, const std::string& cause, double weak, bool is_line,
                       const DihedralParams& params) {
  if (is_line) return fmt::format("A line, because {}.", cause);
  if (side.strength >= weak)
    return "No line: what is here is the line of a neighbour, where the step is nearer or the planes meet.";
  const double gap = rounded_down(side.gap_px), angle = rounded_down(side.angle_deg);
  if (gap / params.gap > angle / params.angle)
    return fmt::format("No line: the largest gap is {:.6g} px; dihedral.gap = {:.6g} would draw it.", gap,
                       gap);
  if (angle > 0.0)
    return fmt::format("No line: the largest angle is {:.6g} degrees; dihedral.angle = {:.6g} would draw it.",
                       angle, angle);
  return "No line: the surface goes on here without an angle or a gap.";
}

bool has_company(const PerBuffer<Image>& maps, const Settings& settings, int x, int y) {
  const Image &angles = maps[BufferName::pair_angles], &gaps = maps[BufferName::pair_gaps];
  const double weak = settings.edges.weak;
  for (int i = 0; i < 9; ++i) {
    const int nx = x + i % 3 - 1, ny = y + i / 3 - 1;
    const bool inside = nx >= 0 && ny >= 0 && nx < angles.width_px && ny < angles.height_px;
    if (i == 4 || !inside) continue;
    if (strength_of(pixel_sides(angles, gaps, settings.dihedral, weak, nx, ny)) >= weak) return true;
  }
  return false;
}

class DihedralDetector final : public EdgeDetector {
 public:
  std::string_view name() const override { return "dihedral"; }
  std::string_view help() const override {
    return "Ours: a line is where neighbours' planes meet at a large angle or lie apart, or objects differ.";
  }
  std::vector<BufferName> maps() const override {
    return {BufferName::pair_angles, BufferName::pair_gaps, BufferName::object_id};
  }
  /// Whether the pixels around are lines depends on their own neighbours.
  int reach_px() const override { return 2; }
  std::vector<std::string> deciding_parameters() const override { return {"dihedral.angle", "dihedral.gap"}; }

  bool has_normal_term(const Settings& settings) const override {
    return settings.dihedral.normals != BendNormals::surface;
  }
  bool sees_facets(const Settings& settings) const override {
    return settings.dihedral.normals != BendNormals::shading || EdgeDetector::sees_facets(settings);
  }
  bool tells_objects(const Settings&) const override { return true; }
  std::optional<Settings> without_depth_term(const Settings& settings) const override {
    Settings without = settings;
    without.dihedral.gap = kMostGap;
    return without;
  }

  Explanation explain(const PerBuffer<Image>& maps, const Settings& settings, int x, int y) const override {
    const DihedralParams& params = settings.dihedral;
    const double weak = settings.edges.weak;
    const Sides sides =
        pixel_sides(maps[BufferName::pair_angles], maps[BufferName::pair_gaps], params, weak, x, y);
    Explanation result{.detector = std::string(name()), .x = x, .y = y, .by_largest = true};
    result.terms = {
        term_of("angle", "Angle to the neighbours", sides, &PixelSide::angle_deg, params.angle, "deg"),
        term_of("gap", "Gap to the neighbours", sides, &PixelSide::gap_px, params.gap, "px")};
    result.sum = result.edge = strength_of(sides);
    result.limit = weak;
    result.limit_name = "limit";
    const bool is_dot = !has_company(maps, settings, x, y);
    result.is_line = result.sum >= weak && !is_dot;
    if (result.is_line) result.line_class = kEdgeClassNames[static_cast<size_t>(class_of(sides, weak))];
    const PixelSide& side = decisive(sides);
    const std::string cause = result.is_line ? cause_of(side, maps, settings, x, y) : "";
    result.terms[side.gap_px > 0.0 ? 1 : 0].cause = cause;
    result.verdict = result.sum >= weak && is_dot
                         ? "No line: it would be a single pixel, without a line in the eight around it."
                         : verdict_of(side, cause, weak, result.is_line, params);
    return result;
  }
};

}  // namespace

const EdgeDetector& dihedral_detector() {
  static const DihedralDetector kDetector;
  return kDetector;
}

}  // namespace inkbench
