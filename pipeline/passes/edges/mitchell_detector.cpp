// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/mitchell_detector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "pipeline/passes/edges/explained_terms.h"
#include "pipeline/passes/edges/paper_sum.h"

namespace inkbench {
namespace {

constexpr int kMitchellReach = 1;
constexpr std::array<Offset, 4> kFourNeighbours{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

glm::dvec3 unit_normal(const Image& map, int x, int y) {
  return glm::normalize(2.0 * glm::dvec3(map.at(x, y, 0), map.at(x, y, 1), map.at(x, y, 2)) - 1.0);
}

/// Exact for small angles too, unlike the arc cosine.
double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::degrees(2.0 * std::atan2(glm::length(a - b), glm::length(a + b)));
}

void include(MitchellTerm& term, double value, Offset at) {
  if (value > term.value) term = {value, at};
}

double shape_share(const MitchellTerms& terms, const MitchellParams& params) {
  return std::max({terms.angle.value / params.angle, terms.depth.value / params.depth,
                   params.use_ids ? terms.id.value : 0.0});
}

std::string object_text(double id, const std::vector<std::string>& names) {
  const auto place = static_cast<size_t>(id);
  if (place == 0) return "the background";
  return place <= names.size() ? names[place - 1] : fmt::format("object {}", place);
}

class MitchellDetector final : public EdgeDetector {
 public:
  std::string_view name() const override { return "mitchell"; }
  std::string_view help() const override {
    return "Mitchell, Brennan and Card's: jumps of normals, depth, object ids and materials' colours between "
           "neighbours, each against its limit.";
  }
  std::vector<BufferName> maps() const override {
    return {BufferName::depth, BufferName::normal, BufferName::object_id, BufferName::albedo};
  }
  int reach_px() const override { return kMitchellReach + 1; }

  Explanation explain(const PerBuffer<Image>& maps, const Settings& settings, int x, int y) const override;

  std::vector<std::string> deciding_parameters() const override {
    return {"mitchell.angle", "mitchell.depth", "mitchell.albedo", "mitchell.use_ids"};
  }
  bool has_normal_term(const Settings&) const override { return true; }
  bool tells_objects(const Settings& settings) const override { return settings.mitchell.use_ids; }
  std::optional<Settings> without_depth_term(const Settings& settings) const override {
    Settings without = settings;
    without.mitchell.depth = 1;  // no two differ by more than the whole depth
    return without;
  }
};

/// The terms with their numbers, without their causes.
std::vector<ExplainedTerm> mitchell_numbers(const MitchellTerms& found, const MitchellParams& params) {
  std::vector<ExplainedTerm> terms{{.name = "angle",
                                    .title = "Angle between the normals",
                                    .value = found.angle.value,
                                    .limit = params.angle,
                                    .unit = "deg"},
                                   {.name = "depth",
                                    .title = "Step of the depth",
                                    .value = found.depth.value,
                                    .limit = params.depth,
                                    .unit = "of far"},
                                   {.name = "id",
                                    .title = "Difference of models",
                                    .used = params.use_ids,
                                    .value = found.id.value,
                                    .limit = 1},
                                   {.name = "albedo",
                                    .title = "Difference of the materials' colours",
                                    .value = found.albedo.value,
                                    .limit = params.albedo}};
  constexpr auto kLargest = ExplainedInput::Role::largest;
  const std::array<const MitchellTerm*, 4> parts{&found.angle, &found.depth, &found.id, &found.albedo};
  for (size_t i = 0; i < terms.size(); ++i)
    terms[i].inputs = {{"largest", parts[i]->value, terms[i].unit, kLargest, parts[i]->at}};
  return terms;
}

/// A pixel that is none itself is drawn where one of its neighbours is a line.
void tell_of_dilation(const MitchellMaps& maps, const Settings& settings, int x, int y, Explanation& why) {
  if (settings.mitchell.thin || why.is_line) return;
  for (int i = 0; i < 9; ++i) {
    const int nx = x + i % 3 - 1, ny = y + i / 3 - 1;
    if (!is_inside_image(*maps.surfaces.depth, nx, ny)) continue;
    if (mitchell_terms(maps, nx, ny).strength(settings.mitchell) < 1) continue;
    why.verdict += " But a neighbour is a line, and lines are made 3 x 3 pixels wide.";
    return;
  }
}

Explanation MitchellDetector::explain(const PerBuffer<Image>& maps, const Settings& settings, int x,
                                      int y) const {
  const Image& depth = maps[BufferName::depth];
  const Image& ids = maps[BufferName::object_id];
  const MitchellMaps all{{&depth, &maps[BufferName::normal], &ids}, &maps[BufferName::albedo]};
  const MitchellParams& params = settings.mitchell;
  const double weak = settings.edges.weak;
  const MitchellTerms found = mitchell_terms(all, x, y);
  const std::vector<std::string> names = model_names(settings);
  std::vector<ExplainedTerm> terms = mitchell_numbers(found, params);
  const auto step = [&](const MitchellTerm& term) {
    return step_between_pixels(all.surfaces, x, y, term.at);
  };
  if (found.angle.value > 0) terms[0].cause = cause_text(step(found.angle), false, names);
  if (found.depth.value > 0) terms[1].cause = cause_text(step(found.depth), true, names);
  if (found.id.value > 0)
    terms[2].cause = fmt::format("{} beside {}", object_text(ids.at(x, y), names),
                                 object_text(ids.at(x + found.id.at.dx, y + found.id.at.dy), names));
  terms[1].around = values_around(depth, x, y);
  terms[2].around = values_around(ids, x, y);
  const LensBlock lens = lens_of(settings.camera, settings.image.height);
  const EdgeClass of = found.is_material(params, weak) ? EdgeClass::material
                                                       : edge_class(all.surfaces, lens, x, y, kMitchellReach);
  Explanation why = explained_by_largest(name(), std::move(terms), found.strength(params), weak, of);
  tell_of_dilation(all, settings, x, y, why);
  return why;
}

}  // namespace

MitchellTerms mitchell_terms(const MitchellMaps& maps, int x, int y) {
  const auto& [depth, normal, object_id] = maps.surfaces;
  MitchellTerms terms;
  for (const Offset& at : kFourNeighbours) {
    const int nx = x + at.dx, ny = y + at.dy;
    if (!is_inside_image(*depth, nx, ny)) continue;
    include(terms.depth, std::abs(double{depth->at(nx, ny)} - depth->at(x, y)), at);
    include(terms.id, object_id->at(nx, ny) != object_id->at(x, y) ? 1 : 0, at);
    if (is_background(depth->at(x, y)) || is_background(depth->at(nx, ny))) continue;
    include(terms.angle, degrees_between(unit_normal(*normal, x, y), unit_normal(*normal, nx, ny)), at);
    for (int c = 0; c < 3; ++c)
      include(terms.albedo, std::abs(double{maps.albedo->at(nx, ny, c)} - maps.albedo->at(x, y, c)), at);
  }
  return terms;
}

double MitchellTerms::strength(const MitchellParams& params) const {
  return std::max(shape_share(*this, params), albedo.value / params.albedo);
}

bool MitchellTerms::is_material(const MitchellParams& params, double weak) const {
  return shape_share(*this, params) < weak && albedo.value / params.albedo >= weak;
}

const EdgeDetector& mitchell_detector() {
  static const MitchellDetector kDetector;
  return kDetector;
}

}  // namespace inkbench
