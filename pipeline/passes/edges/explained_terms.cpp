// SPDX-License-Identifier: MIT
#include "pipeline/passes/edges/explained_terms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "pipeline/base/text.h"

namespace inkbench {
namespace {

double share_of_limit(const ExplainedTerm& term) {
  return term.used ? term.value / term.limit : 0.0;
}

std::string value_text(double value, const std::string& unit) {
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

/// "the angle, 62 deg,"
std::string has_text(const ExplainedTerm& term, bool is_close) {
  std::string title = term.title;
  title[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(title[0])));
  const std::string unit = term.unit.empty() ? "" : " " + term.unit;
  const std::string value =
      is_close ? shortest(static_cast<float>(term.value)) + unit : value_text(term.value, term.unit);
  return fmt::format("the {}, {},", title, value);
}

std::string largest_verdict(const ExplainedTerm& term, bool is_only_one, double strength, double weak) {
  const std::string limit = value_text(term.limit, term.unit);
  const bool is_close = value_text(term.value, term.unit) == limit;  // four digits would not tell them apart
  const std::string has = has_text(term, is_close);
  if (strength >= 1) return fmt::format("A line, because {} reaches the limit {}.", has, limit);
  if (!(strength > 0)) return "No line, because nothing differs here.";
  if (strength >= weak) {
    return fmt::format("A line only where one that reaches its limit goes on here: {} is below the limit {}.",
                       has, limit);
  }
  const std::string others = is_only_one ? "" : ", and all else is farther below its own";
  return fmt::format("No line, because {} is below the limit {}{}.", has, limit, others);
}

}  // namespace

std::vector<std::string> model_names(const Settings& settings) {
  std::vector<std::string> names;
  for (const ModelParams& model : settings.models) names.push_back(model.name);
  return names;
}

Explanation explained_by_largest(std::string_view detector, std::vector<ExplainedTerm> terms, double strength,
                                 double weak, EdgeClass edge_class) {
  Explanation result{.detector = std::string(detector), .by_largest = true};
  const auto less = [](const ExplainedTerm& a, const ExplainedTerm& b) {
    return share_of_limit(a) < share_of_limit(b);
  };
  result.verdict =
      largest_verdict(*std::max_element(terms.begin(), terms.end(), less), terms.size() == 1, strength, weak);
  result.terms = std::move(terms);
  result.sum = strength;
  result.limit = 1;
  result.limit_name = "limit";
  result.edge = strength;
  result.is_line = strength >= 1;
  if (result.is_line) result.line_class = class_name(edge_class);
  return result;
}

}  // namespace inkbench
