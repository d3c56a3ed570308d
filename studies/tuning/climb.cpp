// SPDX-License-Identifier: MIT
#include "studies/tuning/climb.h"

#include <algorithm>
#include <exception>
#include <nlopt.hpp>

namespace inkbench {
namespace {

constexpr double kLeastStep = 0.002;

class Climb {
 public:
  Climb(const SearchSpace& space, const Point& start, const Score& start_score, const std::vector<bool>& open,
        int most, const ScoreOfPoint& score)
      : space_(space), open_(open), best_(start), best_score_(start_score), left_(most), score_(score) {}

  void run(double step) {
    climb_numbers(step, left_ - static_cast<int>(try_count()));
    try_choices();
    if (left_ > 0) climb_numbers(step / 4, left_);
  }

 private:
  size_t try_count() const {
    size_t count = 0;
    for (size_t i = 0; i < space_.size(); ++i) {
      if (!space_[i].is_number() && open_[i]) count += space_[i].choices.size() - 1;
    }
    return count;
  }

  std::vector<size_t> numbers() const {
    std::vector<size_t> sides;
    for (size_t i = 0; i < space_.size(); ++i) {
      if (space_[i].is_number() && open_[i]) sides.push_back(i);
    }
    return sides;
  }

  Score look(const Point& point) {
    --left_;
    const Score score = score_(point);
    if (is_better(score, best_score_)) {
      best_ = point;
      best_score_ = score;
    }
    return score;
  }

  void climb_numbers(double step, int most) {
    const std::vector<size_t> sides = numbers();
    if (sides.empty() || most <= 0) return;
    const Point from = best_;
    nlopt::opt search(nlopt::LN_SBPLX, static_cast<unsigned>(sides.size()));
    const nlopt::vfunc look_at = [](const std::vector<double>& x, std::vector<double>&, void* data) {
      return (*static_cast<std::function<double(const std::vector<double>&)>*>(data))(x);
    };
    std::exception_ptr thrown;
    std::function<double(const std::vector<double>&)> value = [&](const std::vector<double>& x) {
      Point point = from;
      for (size_t i = 0; i < sides.size(); ++i) point[sides[i]] = x[i];
      try {
        return as_number(look(point));
      } catch (...) {  // NLopt hands on no exceptions but its own
        thrown = std::current_exception();
        throw nlopt::forced_stop();
      }
    };
    search.set_max_objective(look_at, &value);
    search.set_lower_bounds(0.0);
    search.set_upper_bounds(1.0);
    search.set_initial_step(std::max(step, 2 * kLeastStep));
    search.set_xtol_abs(kLeastStep);
    search.set_maxeval(most);
    std::vector<double> x;
    for (const size_t i : sides) x.push_back(from[i]);
    double least = 0;
    try {
      search.optimize(x, least);
    } catch (const nlopt::roundoff_limited&) {
      // As close as it gets.
    } catch (const nlopt::forced_stop&) {
      std::rethrow_exception(thrown);
    }
  }

  void try_choices() {
    for (size_t i = 0; i < space_.size(); ++i) {
      if (space_[i].is_number() || !open_[i]) continue;
      const size_t count = space_[i].choices.size();
      for (size_t k = 0; k < count && left_ > 0; ++k) {
        Point point = best_;
        point[i] = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
        if (value_at(space_[i], best_[i]) != value_at(space_[i], point[i])) look(point);
      }
    }
  }

  const SearchSpace& space_;
  const std::vector<bool>& open_;
  Point best_;
  Score best_score_;
  int left_;
  const ScoreOfPoint& score_;
};

}  // namespace

void climb(const SearchSpace& space, const Point& start, const Score& start_score,
           const std::vector<bool>& open, double step, int most, const ScoreOfPoint& score) {
  if (most > 0) Climb(space, start, start_score, open, most, score).run(step);
}

}  // namespace inkbench
