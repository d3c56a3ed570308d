// SPDX-License-Identifier: MIT
#include "studies/tuning/tuner.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "pipeline/base/error.h"
#include "pipeline/base/stop.h"
#include "studies/tuning/climb.h"
#include "studies/tuning/even_cover.h"

namespace inkbench {
namespace {

constexpr size_t kStarts = 3;  // of climbs
constexpr int kMostProfilePoints = 17;
constexpr int kLeastProfilePoints = 5;
constexpr size_t kBatch = 32;  // candidates measured at once, between two looks at the progress

/// How the budget is shared out.
struct Shares {
  int cover = 0, climb = 0, climb_without = 0, profile = 0;
};

Shares share_out(const TuneProblem& problem, int spent) {
  const int left = std::max(problem.budget - spent, 0);
  const auto sides = static_cast<int>(problem.space.size());
  const auto groups = static_cast<int>(problem.groups.size());
  Shares shares;
  // From the default, around the best, and once more where that led to a better place.
  shares.profile = std::min(left / (12 * std::max(sides, 1)), kMostProfilePoints);
  if (shares.profile < kLeastProfilePoints) shares.profile = 0;
  const int rest = left - (shares.profile > 0 ? sides * (3 * shares.profile + 2) : 0);
  if (groups > 1) shares.climb_without = std::max(rest / (3 * groups) - 1, 0);
  const int without = shares.climb_without > 0 ? groups * (shares.climb_without + 1) : 0;
  shares.climb = (rest - without) / 3;
  shares.cover = rest - without - shares.climb;
  return shares;
}

class Tuner {
 public:
  Tuner(const TuneProblem& problem, const MeasureCandidates& measure, const TuneProgress& progress)
      : problem_(problem), measure_(measure), progress_(progress), all_(problem.groups.size(), true) {}

  TuneResult run() {
    try {
      search();
    } catch (const Stopped&) {
      result_.stopped = true;
    }
    if (result_.trials.empty()) throw Stopped();
    if (is_undrawn(result_.tuned()))
      throw input_error("tune", "no candidate could be drawn", "render the scene to see why");
    return std::move(result_);
  }

 private:
  using Measured = std::map<std::string, size_t>;  ///< Trial by values.

  void search() {
    result_.start = look("start", problem_.start, all_);
    result_.best = result_.start;
    for (const Values& other : problem_.others) result_.others.push_back(look("paper", other, all_));
    look_at_choices();
    shares_ = share_out(problem_, static_cast<int>(result_.trials.size()));
    const std::vector<size_t> cover = look_everywhere();
    climb_with_what_is_left(cover);
    find_worth();
    leave_out(cover);
    find_plateau(cover);
  }

  static bool is_undrawn(const Trial& trial) { return trial.score == kNoScore; }

  /// The trial of these values on these groups, measured unless it was.
  size_t look(const std::string& stage, const Values& values, const std::vector<bool>& wanted) {
    return look_at(stage, {values}, wanted).front();
  }

  std::vector<size_t> look_at(const std::string& stage, const std::vector<Values>& candidates,
                              const std::vector<bool>& wanted) {
    std::vector<size_t> places(candidates.size());
    std::vector<Values> unknown;
    std::vector<size_t> of_unknown;
    Measured& measured = measured_[wanted];
    std::set<std::string> asked;
    for (size_t i = 0; i < candidates.size(); ++i) {
      const std::string text = values_text(problem_.space, candidates[i]);
      if (measured.contains(text) || !asked.insert(text).second) continue;
      unknown.push_back(candidates[i]);
    }
    for (size_t first = 0; first < unknown.size(); first += kBatch) {
      const std::vector<Values> batch(
          unknown.begin() + static_cast<long>(first),
          unknown.begin() + static_cast<long>(std::min(first + kBatch, unknown.size())));
      std::vector<GroupTallies> tallies = measure_(batch, wanted);
      for (size_t k = 0; k < batch.size(); ++k) add(stage, batch[k], std::move(tallies[k]), wanted);
    }
    for (size_t i = 0; i < candidates.size(); ++i)
      places[i] = measured.at(values_text(problem_.space, candidates[i]));
    return places;
  }

  void add(const std::string& stage, const Values& values, GroupTallies&& groups,
           const std::vector<bool>& wanted) {
    const size_t place = result_.trials.size();
    Trial trial{stage, values, std::move(groups), {}, wanted == all_};
    trial.score = score(trial.groups, wanted);
    result_.trials.push_back(std::move(trial));
    measured_[wanted][values_text(problem_.space, values)] = place;
    const Trial& added = result_.trials.back();
    if (added.is_whole && is_better(added.score, result_.tuned().score)) result_.best = place;
    if (progress_) progress_(added, result_.trials.size(), result_.tuned());
  }

  /// Pooled over these groups.
  Score score(const GroupTallies& groups, const std::vector<bool>& wanted) const {
    DrawingTally sum;
    for (size_t g = 0; g < groups.size(); ++g) {
      if (!wanted[g]) continue;
      if (!groups[g]) return kNoScore;
      sum.add(*groups[g]);
    }
    return score_of(problem_.objective, sum);
  }

  /// The default with every other choice, one at a time: another method with numbers that were made for it.
  void look_at_choices() {
    std::vector<Values> candidates;
    for (size_t i = 0; i < problem_.space.size(); ++i) {
      for (const Value& choice : problem_.space[i].choices) {
        candidates.push_back(problem_.start);
        candidates.back()[i] = choice;
      }
    }
    candidates.resize(std::min(candidates.size(), static_cast<size_t>(problem_.budget) / 3));
    const std::vector<size_t> trials = look_at("choice", candidates, all_);
    result_.others.insert(result_.others.end(), trials.begin(), trials.end());
  }

  /// Again from the best few there are by then, until the share is spent or leads nowhere new.
  void climb_with_what_is_left(const std::vector<size_t>& cover) {
    const size_t before = result_.trials.size();
    std::vector<size_t> from = seeds(cover);
    while (true) {
      const size_t last = result_.trials.size();
      climb_from_best("climb", all_, shares_.climb - static_cast<int>(last - before), from);
      if (result_.trials.size() == last) return;
      for (size_t i = last; i < result_.trials.size(); ++i) from.push_back(i);
    }
  }

  std::vector<size_t> look_everywhere() {
    std::vector<Values> candidates;
    for (const Point& point : even_cover(problem_.space, std::max(shares_.cover, 1), problem_.seed))
      candidates.push_back(values_at(problem_.space, point));
    result_.cover = look_at("cover", candidates, all_);
    return result_.cover;
  }

  /// What any search may begin from: nothing that was found by looking at scores.
  std::vector<size_t> seeds(std::vector<size_t> cover) const {
    cover.push_back(result_.start);
    cover.insert(cover.end(), result_.others.begin(), result_.others.end());
    return cover;
  }

  /// The choices among the values, as one text.
  std::string choices_of(const Values& values) const {
    std::string text;
    for (size_t i = 0; i < problem_.space.size(); ++i) {
      if (!problem_.space[i].is_number()) text += to_text(values[i]) + " ";
    }
    return text;
  }

  /// The best few of these, by these groups: the best of different choices first, no two close together.
  std::vector<size_t> best_few(const std::vector<size_t>& trials, const std::vector<bool>& wanted) const {
    std::vector<size_t> order = trials;
    std::map<size_t, Score> scores;  // pooling is dear
    for (const size_t trial : trials) scores.try_emplace(trial, score(result_.trials[trial].groups, wanted));
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return is_better(scores.at(a), scores.at(b)); });
    std::vector<size_t> few;
    std::set<std::string> seen;
    for (const size_t trial : order) {
      if (few.size() < kStarts && seen.insert(choices_of(result_.trials[trial].values)).second)
        few.push_back(trial);
    }
    for (const size_t trial : order) {
      if (few.size() == kStarts) break;
      const bool is_near = std::any_of(few.begin(), few.end(), [&](size_t other) {
        return distance(result_.trials[trial].values, result_.trials[other].values) < 2 * spacing();
      });
      if (!is_near) few.push_back(trial);
    }
    return few;
  }

  /// The largest difference along a side, in shares.
  double distance(const Values& a, const Values& b) const {
    const Point at_a = point_of(problem_.space, a), at_b = point_of(problem_.space, b);
    double most = 0;
    for (size_t i = 0; i < at_a.size(); ++i) most = std::max(most, std::abs(at_a[i] - at_b[i]));
    return most;
  }

  double spacing() const {
    const auto sides = static_cast<double>(problem_.space.size());
    return std::pow(static_cast<double>(std::max<size_t>(result_.cover.size(), 2)), -1.0 / sides);
  }

  /// Returns the best trial by these groups, of the seeds and of what it looked at.
  size_t climb_from_best(const std::string& stage, const std::vector<bool>& wanted, int most,
                         const std::vector<size_t>& seeds) {
    const std::vector<size_t> starts = best_few(seeds, wanted);
    size_t best = starts.front();
    Score best_score = score(result_.trials[best].groups, wanted);
    const size_t before = result_.trials.size();
    for (size_t k = 0; k < starts.size(); ++k) {
      const int spent = static_cast<int>(result_.trials.size() - before);
      const int share = (most - spent) / static_cast<int>(starts.size() - k);
      const Values from = result_.trials[starts[k]].values;
      const Score from_score = score(result_.trials[starts[k]].groups, wanted);
      climb(problem_.space, point_of(problem_.space, from), from_score, open_sides(from), spacing(), share,
            [&](const Point& point) {
              const size_t trial = look(stage, values_at(problem_.space, point), wanted);
              const Score found = score(result_.trials[trial].groups, wanted);
              if (is_better(found, best_score)) {
                best = trial;
                best_score = found;
              }
              return found;
            });
    }
    return best;
  }

  std::vector<bool> open_sides(const Values& values) const {
    const Settings settings = with_values(problem_.base, problem_.space, values);
    std::vector<bool> open;
    for (const SearchAxis& axis : problem_.space) open.push_back(has_effect(settings, axis.key));
    return open;
  }

  void find_worth() {
    for (size_t i = 0; i < problem_.space.size(); ++i) {
      AxisWorth& axis = result_.axes.emplace_back();
      axis.key = problem_.space[i].key;
    }
    if (shares_.profile == 0) return;
    for (size_t i = 0; i < problem_.space.size(); ++i) profile_alone(i);
    const size_t before = result_.best;
    for (size_t i = 0; i < problem_.space.size(); ++i) profile_around(i);
    if (result_.best == before) return;
    // A profile went through a better place: what was measured around the old one is kept but for the scores.
    for (size_t i = 0; i < problem_.space.size(); ++i) profile_around(i);
  }

  std::vector<Value> profile_values(size_t side) const {
    const SearchAxis& axis = problem_.space[side];
    if (!axis.is_number()) return axis.choices;
    std::vector<Value> values;
    for (int k = 0; k < shares_.profile; ++k) {
      const Value value = value_at(axis, static_cast<double>(k) / (shares_.profile - 1));
      if (values.empty() || values.back() != value) values.push_back(value);
    }
    return values;
  }

  Profile profile(const std::string& stage, const Values& middle, size_t side) {
    Profile profile{profile_values(side), {}};
    std::vector<Values> candidates;
    for (const Value& value : profile.values) {
      candidates.push_back(middle);
      candidates.back()[side] = value;
    }
    for (const size_t trial : look_at(stage + " " + problem_.space[side].key, candidates, all_))
      profile.scores.push_back(result_.trials[trial].score);
    return profile;
  }

  void profile_alone(size_t side) {
    AxisWorth& axis = result_.axes[side];
    axis.alone = profile("alone", problem_.start, side);
    axis.best_alone = problem_.start[side];
    axis.alone_score = result_.initial().score;
    for (size_t k = 0; k < axis.alone.values.size(); ++k) {
      if (!is_better(axis.alone.scores[k], axis.alone_score)) continue;
      axis.best_alone = axis.alone.values[k];
      axis.alone_score = axis.alone.scores[k];
    }
  }

  void profile_around(size_t side) {
    const Trial tuned = result_.tuned();
    AxisWorth& axis = result_.axes[side];
    axis.around = profile("around", tuned.values, side);
    Values without = tuned.values;
    without[side] = problem_.start[side];
    axis.without = result_.trials[look("around " + axis.key, without, all_)].score;
    axis.has_effect = has_effect(with_values(problem_.base, problem_.space, tuned.values), axis.key);
    axis.spread = spread_of(axis.around);
    axis.equally_good = equally_good(problem_.space[side], axis.around, tuned.score, tuned.values[side]);
  }

  static double spread_of(const Profile& profile) {
    double low = 1e300, high = -1e300;
    for (const Score& score : profile.scores) {
      low = std::min(low, as_number(score));
      high = std::max(high, as_number(score));
    }
    return profile.scores.empty() ? 0 : high - low;
  }

  static std::optional<std::pair<double, double>> equally_good(const SearchAxis& axis, const Profile& profile,
                                                               const Score& best, const Value& value) {
    if (!axis.is_number()) return std::nullopt;
    const double middle = share_of(axis, value);
    double low = middle, high = middle;
    for (size_t k = profile.values.size(); k-- > 0;) {
      const double at = share_of(axis, profile.values[k]);
      if (at > middle) continue;
      if (!is_as_good(profile.scores[k], best)) break;
      low = at;
    }
    for (size_t k = 0; k < profile.values.size(); ++k) {
      const double at = share_of(axis, profile.values[k]);
      if (at < middle) continue;
      if (!is_as_good(profile.scores[k], best)) break;
      high = at;
    }
    const auto number = [&](double share) {
      const Value there = share == middle ? value : value_at(axis, share);
      return std::stod(to_text(there));  // as it was rounded, not as a float holds it
    };
    return std::pair(number(low), number(high));
  }

  static bool is_as_good(const Score& score, const Score& best) {
    return as_number(score) >= as_number(best) - kPlateau;
  }

  void leave_out(const std::vector<size_t>& cover) {
    const size_t count = problem_.groups.size();
    if (count < 2) return;
    DrawingTally pooled;
    for (size_t g = 0; g < count; ++g) {
      std::vector<bool> others(count, true), alone(count, false);
      others[g] = false;
      alone[g] = true;
      const std::string stage = "without " + problem_.groups[g];
      const size_t best = climb_from_best(stage, others, shares_.climb_without, seeds(cover));
      LeftOut left{problem_.groups[g],
                   result_.trials[best].values,
                   score(result_.trials[best].groups, others),
                   {},
                   score(result_.initial().groups, alone)};
      const size_t judged = result_.trials[best].groups[g] ? best : look(stage, left.values, alone);
      left.tuned = score(result_.trials[judged].groups, alone);
      if (result_.trials[judged].groups[g]) pooled.add(*result_.trials[judged].groups[g]);
      result_.left_out.push_back(std::move(left));
    }
    result_.left_out_tuned = score_of(problem_.objective, pooled);
  }

  void find_plateau(const std::vector<size_t>& cover) {
    const Score best = result_.tuned().score;
    const auto good = std::count_if(cover.begin(), cover.end(), [&](size_t trial) {
      return is_as_good(result_.trials[trial].score, best);
    });
    result_.plateau = static_cast<double>(good) / static_cast<double>(cover.size());
  }

  const TuneProblem& problem_;
  const MeasureCandidates& measure_;
  const TuneProgress& progress_;
  std::vector<bool> all_;
  Shares shares_;
  std::map<std::vector<bool>, Measured> measured_;
  TuneResult result_;
};

}  // namespace

bool AxisWorth::matters() const {
  constexpr double kLeastSpread = 0.001;
  return has_effect && spread >= kLeastSpread;
}

std::optional<bool> TuneResult::is_gain() const {
  if (!left_out_tuned) return std::nullopt;
  return is_better(*left_out_tuned, initial().score);
}

TuneResult tune(const TuneProblem& problem, const MeasureCandidates& measure, const TuneProgress& progress) {
  return Tuner(problem, measure, progress).run();
}

}  // namespace inkbench
