// SPDX-License-Identifier: MIT
// What a search wants: a weighted sum of measures to be as large as can be, and limits that measures must
// keep. In: what a drawing adds up to over all views. Out: a score, by which drawings can be ordered.
#pragma once

#include <string>
#include <vector>

#include "studies/measures/measures.h"

namespace inkbench {

/// A measure in the sum. One of which less is better counts against it.
struct ObjectiveTerm {
  const Measure* measure = nullptr;
  double weight = 1;  ///< Above 0.
};

/// "recall_crease >= 0.8".
struct Constraint {
  const Measure* measure = nullptr;
  bool at_least = true;
  double limit = 0;

  std::string text() const;
};

struct Objective {
  std::vector<ObjectiveTerm> terms;
  std::vector<Constraint> constraints;

  /// All measures that it names, each once.
  std::vector<const Measure*> measures() const;
  /// "f1 + 0.5 recall_crease, with ink <= 0.05".
  std::string text() const;
};

/// F alone.
Objective default_objective();
/// Marks, and where `with_reference` a small weight on F.
Objective marks_objective(bool with_reference);

/// Errors (input): no such measure, one that cannot be searched for, a limit that is no number, no <= or >=.
Constraint parse_constraint(const std::string& text, const std::string& where);

/// The measure of that name. Errors (input): there is none; it needs more than single views drawn as they are
/// (a camera path, other levels of the mesh, causes, antialiasing).
const Measure& searchable_measure(const std::string& name, const std::string& where);

/// Of one drawing. Those that keep all limits come first, by value; of the others the one that misses them by
/// less is better. A measure without a value (a recall over no lines) counts 0 in the sum and keeps any
/// limit.
struct Score {
  double value = 0;  ///< The sum, whatever the limits.
  double missed_by =
      0;  ///< How far limits are missed in sum, each in shares of itself; 0 where all are kept.

  bool keeps_limits() const { return missed_by <= 0; }
  bool operator==(const Score&) const = default;
};

/// Of what could not be drawn.
inline constexpr Score kNoScore{-1e30, 1e30};

bool is_better(const Score& a, const Score& b);

/// One number in the same order, for searches that know no limits.
double as_number(const Score& score);

Score score_of(const Objective& objective, const DrawingTally& tally);

}  // namespace inkbench
