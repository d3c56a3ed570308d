// SPDX-License-Identifier: MIT
#include "pipeline/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/deciding_values.h"
#include "pipeline/passes/edges/edge_detector.h"

namespace inkbench {
namespace {

std::string with_unit(double value, const std::string& unit) {
  return fmt::format("{:.6g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string place_text(const Offset& at) {
  if (at == Offset{}) return "here";
  std::string text;
  if (at.dy != 0) text = at.dy < 0 ? "above" : "below";
  if (at.dx != 0) text += fmt::format("{}{}", text.empty() ? "" : " ", at.dx < 0 ? "left" : "right");
  return text;
}

std::string term_text(const ExplainedTerm& term, bool by_largest) {
  if (!term.used) return fmt::format("{}: is switched off\n", term.title);
  const std::string value = with_unit(term.value, term.unit), limit = with_unit(term.limit, term.unit);
  std::string text = by_largest ? fmt::format("{}: {}; the limit is {}\n", term.title, value, limit)
                                : fmt::format("{}: adds {} of at most {}\n", term.title, value, limit);
  for (const ExplainedInput& input : term.inputs) {
    const std::string where = input.at ? "  (" + place_text(*input.at) + ")" : "";
    text += fmt::format("  {:<18} {}{}\n", input.name, with_unit(input.value, input.unit), where);
  }
  if (!term.cause.empty()) text += "  " + term.cause + "\n";
  return text;
}

nlohmann::ordered_json json_of(const ExplainedTerm& term) {
  nlohmann::ordered_json inputs = nlohmann::ordered_json::array();
  for (const ExplainedInput& input : term.inputs) {
    nlohmann::ordered_json entry{{"name", input.name}, {"value", input.value}, {"unit", input.unit}};
    if (input.at) entry["at"] = {input.at->dx, input.at->dy};
    inputs.push_back(entry);
  }
  nlohmann::ordered_json around = nlohmann::ordered_json::array();
  for (const std::optional<float>& value : term.around)
    around.push_back(value ? nlohmann::ordered_json(*value) : nullptr);
  return {{"name", term.name}, {"used", term.used}, {"value", term.value}, {"limit", term.limit},
          {"unit", term.unit}, {"inputs", inputs},  {"around", around},    {"cause", term.cause}};
}

void check_inside(const ImageParams& image, int x, int y) {
  if (x >= 0 && y >= 0 && x < image.width && y < image.height) return;
  throw input_error(fmt::format("pixel {}, {}", x, y), "is not inside the image",
                    fmt::format("x is from 0 to {}, y from 0 to {}", image.width - 1, image.height - 1));
}

/// What the detector says of the pixel (x, y) of its maps, and what would have it say otherwise.
Explanation explained_with_changes(const PerBuffer<Image>& maps, const Settings& settings, int x, int y,
                                   double drawn) {
  const EdgeDetector& detector = edge_detector(settings);
  Explanation explanation = detector.explain(maps, settings, x, y);
  explanation.drawn = drawn;
  const bool is_strength = explanation.by_largest && drawn > 0;
  const double off = is_strength ? 2 * std::abs(explanation.edge - drawn) / drawn : 0;
  explanation.changes = deciding_values(detector, maps, settings, x, y, std::isfinite(off) ? off : 0);
  return explanation;
}

std::string changes_text(const Explanation& explanation) {
  const char* what = explanation.is_line ? "remove" : "draw";
  if (explanation.changes.empty())
    return fmt::format("No useful value of a single limit would {} it.\n", what);
  std::string text = fmt::format("Would {} it:\n", what);
  for (const ExplainedChange& change : explanation.changes)
    text +=
        fmt::format("  {} = {}  (now {})\n", change.parameter, to_text(change.value), to_text(change.now));
  return text;
}

nlohmann::ordered_json json_of(const ExplainedChange& change) {
  // As text has them: a float's shortest digits.
  const auto number = [](const Value& value) { return nlohmann::ordered_json::parse(to_text(value)); };
  return {{"parameter", change.parameter}, {"value", number(change.value)}, {"now", number(change.now)}};
}

}  // namespace

KeptMaps keep_maps(const Frame& frame) {
  KeptMaps maps{frame.settings(), {}, edge_detector(frame.settings()).decided()};
  std::vector<BufferName> kept = edge_detector(frame.settings()).maps();
  for (const BufferName buffer : all_buffers()) {
    if (buffer.info().shown_as != ShownAs::drawing) kept.push_back(buffer);
  }
  kept.push_back(maps.decided);
  for (const BufferName buffer : kept) {
    if (maps.raw[buffer].samples.empty()) maps.raw[buffer] = frame.raw(buffer);
  }
  return maps;
}

Explanation explain_pixel(const KeptMaps& maps, int x, int y) {
  check_inside(maps.settings.image, x, y);
  Explanation explanation =
      explained_with_changes(maps.raw, maps.settings, x, y, maps.raw[maps.decided].at(x, y));
  explanation.x = x;
  explanation.y = y;
  return explanation;
}

Explanation explain_pixel(const Frame& frame, int x, int y) {
  const ImageParams& image = frame.settings().image;
  check_inside(image, x, y);
  const EdgeDetector& detector = edge_detector(frame.settings());
  const int reach = detector.reach_px();
  const int left = std::max(x - reach, 0), top = std::max(y - reach, 0);
  const int width = std::min(x + reach + 1, image.width) - left;
  const int height = std::min(y + reach + 1, image.height) - top;
  PerBuffer<Image> maps;
  for (const BufferName map : detector.maps()) maps[map] = frame.raw_part(map, left, top, width, height);
  Explanation explanation = explained_with_changes(maps, frame.settings(), x - left, y - top,
                                                   frame.pixel(detector.decided(), x, y).at(0, 0));
  explanation.x = x;
  explanation.y = y;
  return explanation;
}

std::string explanation_text(const Explanation& explanation) {
  std::string text = fmt::format(
      "Pixel {}, {} by the detector '{}'{}\n{}\n", explanation.x, explanation.y, explanation.detector,
      explanation.line_class.empty() ? "" : ": a line of class " + explanation.line_class,
      explanation.verdict);
  for (const ExplainedTerm& term : explanation.terms) text += term_text(term, explanation.by_largest);
  return text + changes_text(explanation);
}

std::string explanation_json(const Explanation& explanation) {
  nlohmann::ordered_json json{{"detector", explanation.detector},
                              {"pixel", {explanation.x, explanation.y}},
                              {"line", explanation.is_line},
                              {"class", explanation.line_class},
                              {"by_largest", explanation.by_largest},
                              {"sum", explanation.sum},
                              {"limit", explanation.limit},
                              {"unit", explanation.unit},
                              {"edge", explanation.edge},
                              {"drawn", explanation.drawn},
                              {"verdict", explanation.verdict}};
  json["terms"] = nlohmann::ordered_json::array();
  for (const ExplainedTerm& term : explanation.terms) json["terms"].push_back(json_of(term));
  json["changes"] = nlohmann::ordered_json::array();
  for (const ExplainedChange& change : explanation.changes) json["changes"].push_back(json_of(change));
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace inkbench
