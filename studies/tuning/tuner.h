// SPDX-License-Identifier: MIT
// Values searched for. In: a space, an objective, groups of pictures, and something that measures candidates
// on them. Out: the best values found, how far they can be trusted (leave-one-out), and what each parameter
// is worth. Knows no files and draws nothing.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "studies/tuning/objective.h"
#include "studies/tuning/search_space.h"

namespace inkbench {

/// What a candidate's pictures of one group add up to; none where it could not be drawn or was not asked for.
using GroupTallies = std::vector<std::optional<DrawingTally>>;

/// Draws and measures candidates on the pictures of the groups for which `wanted` is true; a result for each
/// candidate, with an entry for each group. May throw `Stopped`.
using MeasureCandidates = std::function<std::vector<GroupTallies>(const std::vector<Values>& candidates,
                                                                  const std::vector<bool>& wanted)>;

struct TuneProblem {
  SearchSpace space;
  Objective objective;
  Settings base;                    ///< For telling which parameters have an effect under which others.
  std::vector<std::string> groups;  ///< At least one.
  Values start;                     ///< What the scene has: the default.
  std::vector<Values> others;       ///< Looked at as well, whatever the box: the paper's.
  int budget = 400;                 ///< Candidates at most, those of leave-one-out included.
  uint64_t seed = 1;
};

/// One candidate that was looked at.
struct Trial {
  std::string
      stage;  ///< "start", "paper", "choice", "cover", "climb", "without GROUP", "alone KEY", "around KEY".
  Values values;
  GroupTallies groups;
  Score score;           ///< Over the groups that it was measured on.
  bool is_whole = true;  ///< All of them.
};

/// Scores along one side, the other values as they are in the middle.
struct Profile {
  std::vector<Value> values;
  std::vector<Score> scores;
};

struct AxisWorth {
  std::string key;
  Profile alone;           ///< From the default, this one moved alone.
  Profile around;          ///< From the tuned values.
  Value best_alone;        ///< The value that does most for the default.
  Score alone_score;       ///< With it.
  Score without;           ///< The tuned values with this one as the default has it.
  bool has_effect = true;  ///< By its description, under the tuned values.
  double spread = 0;       ///< Largest less least value along `around`.
  /// Of numbers: the ends of the range around the tuned value that is within `kPlateau` of its score.
  std::optional<std::pair<double, double>> equally_good;

  bool matters() const;
};

/// Tuned without a group, judged on it.
struct LeftOut {
  std::string group;
  Values values;
  Score trained;       ///< On the other groups.
  Score tuned, start;  ///< On the group.
};

/// Within so much of the best score a candidate is as good.
inline constexpr double kPlateau = 0.01;

struct TuneResult {
  std::vector<Trial> trials;   ///< In order.
  size_t start = 0, best = 0;  ///< Of them.
  std::vector<size_t>
      others;                 ///< Trials of `TuneProblem::others`, and of the start with another choice each.
  std::vector<size_t> cover;  ///< Trials of the even cover.
  double plateau = 0;         ///< Share of the cover's points within `kPlateau` of the best.
  std::vector<AxisWorth> axes;
  std::vector<LeftOut> left_out;        ///< Empty with one group.
  std::optional<Score> left_out_tuned;  ///< Pooled over the groups, each with the values found without it.
  bool stopped = false;

  const Trial& tuned() const { return trials[best]; }
  const Trial& initial() const { return trials[start]; }
  /// Whether leave-one-out is better than the default: none where nothing could be left out.
  std::optional<bool> is_gain() const;
};

/// Told after each candidate; `best` is of those measured on all groups.
using TuneProgress = std::function<void(const Trial& trial, size_t done, const Trial& best)>;

/// Same problem and measures, same result. Where measuring stops, the best so far. Errors (input): no
/// candidate could be drawn.
TuneResult tune(const TuneProblem& problem, const MeasureCandidates& measure,
                const TuneProgress& progress = {});

}  // namespace inkbench
