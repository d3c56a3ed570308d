// SPDX-License-Identifier: MIT
#include "studies/tuning/objective.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

bool is_searchable(const Measure& measure) {
  const bool needs_more = measure.needs == Need::placed_lines || measure.needs == Need::strengths ||
                          measure.needs == Need::causes;
  return !needs_more && !measure.of_level() && !measure.of_path();
}

}  // namespace

std::string Constraint::text() const {
  return measure->key + (at_least ? " >= " : " <= ") + shortest(limit);
}

std::vector<const Measure*> Objective::measures() const {
  std::vector<const Measure*> result;
  const auto add = [&](const Measure* measure) {
    if (std::find(result.begin(), result.end(), measure) == result.end()) result.push_back(measure);
  };
  for (const ObjectiveTerm& term : terms) add(term.measure);
  for (const Constraint& constraint : constraints) add(constraint.measure);
  return result;
}

std::string Objective::text() const {
  std::string text;
  for (const ObjectiveTerm& term : terms) {
    const bool is_cost = term.measure->better == Better::less;
    text += text.empty() ? (is_cost ? "-" : "") : (is_cost ? " - " : " + ");
    if (term.weight != 1) text += shortest(term.weight) + " ";
    text += term.measure->key;
  }
  for (size_t i = 0; i < constraints.size(); ++i)
    text += (i == 0 ? ", with " : " and ") + constraints[i].text();
  return text;
}

Objective default_objective() {
  return {{{find_measure("f1"), 1.0}}, {}};
}

Objective marks_objective(bool with_reference) {
  Objective objective{{{find_measure("marks"), 1.0}}, {}};
  if (with_reference) objective.terms.push_back({find_measure("f1"), 0.05});
  return objective;
}

const Measure& searchable_measure(const std::string& name, const std::string& where) {
  std::vector<std::string> known;
  for (const Measure& measure : measure_table()) {
    if (is_searchable(measure)) known.push_back(measure.key);
  }
  const Measure* measure = find_measure(name);
  if (measure == nullptr) throw input_error(where, "unknown measure '" + name + "'", suggest(name, known));
  if (is_searchable(*measure)) return *measure;
  throw input_error(where, "the measure '" + name + "' needs more than single views as they are drawn",
                    "a search can look at: " + join(known, ", "));
}

Constraint parse_constraint(const std::string& text, const std::string& where) {
  const size_t at = std::min(text.find(">="), text.find("<="));
  if (at == std::string::npos)
    throw input_error(where, "the constraint \"" + text + "\" has neither >= nor <=",
                      "write one like \"recall_crease >= 0.8\"");
  const std::string name(trim(std::string_view(text).substr(0, at)));
  const std::string number(trim(std::string_view(text).substr(at + 2)));
  char* end = nullptr;
  const double limit = std::strtod(number.c_str(), &end);
  if (number.empty() || *end != '\0' || !std::isfinite(limit))
    throw input_error(where, "the limit \"" + number + "\" of " + name + " is no number",
                      "write one like \"recall_crease >= 0.8\"");
  return {&searchable_measure(name, where), text[at] == '>', limit};
}

bool is_better(const Score& a, const Score& b) {
  if (a.keeps_limits() != b.keeps_limits()) return a.keeps_limits();
  if (!a.keeps_limits() && a.missed_by != b.missed_by) return a.missed_by < b.missed_by;
  return a.value > b.value;
}

double as_number(const Score& score) {
  constexpr double kBelowAll = -1e3;  // weighted sums of measures do not come near it
  return score.keeps_limits() ? score.value : kBelowAll - std::min(score.missed_by, 1e6);
}

Score score_of(const Objective& objective, const DrawingTally& tally) {
  Score score;
  for (const ObjectiveTerm& term : objective.terms) {
    const double value = term.measure->value(tally).value_or(0.0);
    score.value += (term.measure->better == Better::less ? -term.weight : term.weight) * value;
  }
  for (const Constraint& constraint : objective.constraints) {
    const std::optional<double> value = constraint.measure->value(tally);
    if (!value) continue;
    const double missed = constraint.at_least ? constraint.limit - *value : *value - constraint.limit;
    if (missed > 0) score.missed_by += missed / std::max(std::abs(constraint.limit), 1e-9);
  }
  return score;
}

}  // namespace inkbench
