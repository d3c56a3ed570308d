// SPDX-License-Identifier: MIT
#include "pipeline/strokes/carry_along.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace inkbench {
namespace {

struct KnownPlace {
  uint64_t place = 0;
  size_t course = 0;
  float along_px = 0.0F;
  bool operator<(const KnownPlace& other) const {
    return std::tie(place, course, along_px) < std::tie(other.place, other.course, other.along_px);
  }
};

/// All places of the courses, in their order.
std::vector<KnownPlace> known_places(const std::vector<StrokeCourse>& courses) {
  std::vector<KnownPlace> known;
  for (size_t i = 0; i < courses.size(); ++i) {
    for (const PlaceAlong& place : courses[i].places) known.push_back({place.place, i, place.along_px});
  }
  std::sort(known.begin(), known.end());
  return known;
}

/// Calls `visit(known)` for each of that place.
template <class Visit>
void visit_known(const std::vector<KnownPlace>& known, uint64_t place, const Visit& visit) {
  const KnownPlace least{place, 0, -1e30F};
  for (auto at = std::lower_bound(known.begin(), known.end(), least); at != known.end() && at->place == place;
       ++at)
    visit(*at);
}

/// A place that a path and a course share.
struct SharedPlace {
  float here_px = 0.0F, there_px = 0.0F;
};

struct Continued {
  size_t course = 0;
  std::vector<SharedPlace> shared;  ///< In the order of the path.
};

/// The course with which these places share most; the earlier one of two.
std::optional<Continued> continued_by(const std::vector<PlaceAlong>& places,
                                      const std::vector<KnownPlace>& known) {
  std::map<size_t, std::vector<SharedPlace>> by_course;
  for (const PlaceAlong& place : places) {
    visit_known(known, place.place, [&](const KnownPlace& there) {
      by_course[there.course].push_back({place.along_px, there.along_px});
    });
  }
  std::optional<Continued> best;
  for (auto& [course, shared] : by_course) {
    if (!best || shared.size() > best->shared.size()) best = Continued{course, std::move(shared)};
  }
  return best;
}

bool runs_against(const std::vector<SharedPlace>& shared) {
  int forward = 0;
  for (size_t i = 1; i < shared.size(); ++i) {
    const float step = shared[i].there_px - shared[i - 1].there_px;
    forward += step > 0.0F ? 1 : step < 0.0F ? -1 : 0;
  }
  return forward < 0;
}

float median(std::vector<float> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The closed path begun elsewhere; `along_px` begins with 0.
StrokePath begun_at(const StrokePath& path, float along_px) {
  const float first = path.points.front().along_px, round = length_px(path);
  const auto moved = [&](float along) {
    // What lies at the start to rounding stays there.
    return along > along_px - 1e-3F ? std::max(along - along_px, 0.0F) : along - along_px + round;
  };
  StrokePath result = path;
  PathPoint start = point_at(path, along_px);
  result.points.assign(1, start);
  result.points.front().along_px = 0.0F;
  // The last point is the first one again.
  for (const bool is_after : {true, false}) {
    for (size_t i = 0; i + 1 < path.points.size(); ++i) {
      PathPoint point = path.points[i];
      const bool counts = is_after ? point.along_px > along_px : point.along_px < along_px;
      if (!counts) continue;
      point.along_px = moved(point.along_px);
      result.points.push_back(point);
    }
  }
  start.along_px = round;
  result.points.push_back(start);
  for (PlaceAlong& place : result.places)
    place.along_px = moved(std::clamp(place.along_px, first, first + round));
  std::sort(result.places.begin(), result.places.end(),
            [](const PlaceAlong& a, const PlaceAlong& b) { return a.along_px < b.along_px; });
  return result;
}

/// Where the path has what the course began with.
float start_of(const Continued& continued, const StrokeCourse& course, const StrokePath& path) {
  const auto first =
      std::min_element(continued.shared.begin(), continued.shared.end(),
                       [](const SharedPlace& a, const SharedPlace& b) { return a.there_px < b.there_px; });
  const float round = length_px(path), from = path.points.front().along_px;
  const float start = first->here_px - (first->there_px - course.start_px);
  return from + std::fmod(std::fmod(start - from, round) + round, round);
}

void shift(StrokePath& path, float by_px) {
  for (PathPoint& point : path.points) point.along_px += by_px;
  for (PlaceAlong& place : path.places) place.along_px += by_px;
}

void carry(StrokePath& path, const Strokes& before, const std::vector<KnownPlace>& known) {
  std::optional<Continued> continued = continued_by(path.places, known);
  if (!continued) return;
  const StrokeCourse& course = before.courses[continued->course];
  if (runs_against(continued->shared)) {
    path = reversed(path);
    continued = continued_by(path.places, known);
  }
  if (path.is_closed && course.is_closed) {
    path = begun_at(path, start_of(*continued, course, path));
    continued = continued_by(path.places, known);
  }
  std::vector<float> shifts;
  for (const SharedPlace& place : continued->shared) shifts.push_back(place.there_px - place.here_px);
  shift(path, median(std::move(shifts)));
  path.number = course.number;
}

/// Into how many courses the places go on, of which at least a tenth in each.
int continuations(const std::vector<PlaceAlong>& places, const std::vector<KnownPlace>& known) {
  std::map<size_t, size_t> counts;
  size_t all = 0;
  for (const PlaceAlong& place : places) {
    bool goes_on = false;
    visit_known(known, place.place, [&](const KnownPlace& there) {
      ++counts[there.course];
      goes_on = true;
    });
    all += goes_on ? 1 : 0;
  }
  return static_cast<int>(std::count_if(counts.begin(), counts.end(),
                                        [&](const auto& count) { return 10 * count.second >= all; }));
}

}  // namespace

void carry_along(std::vector<StrokePath>& paths, const Strokes& before) {
  const std::vector<KnownPlace> known = known_places(before.courses);
  for (StrokePath& path : paths) carry(path, before, known);
}

StrokeCarrying carrying_between(const Strokes& before, const Strokes& now) {
  StrokeCarrying carrying;
  const std::vector<KnownPlace> then = known_places(before.courses), here = known_places(now.courses);
  for (const StrokeCourse& course : now.courses) {
    const std::optional<Continued> continued = continued_by(course.places, then);
    if (!continued) continue;
    for (const SharedPlace& place : continued->shared)
      carrying.shifts_px.push_back(place.here_px - place.there_px);
  }
  for (const StrokeCourse& course : before.courses) {
    if (course.places.empty()) continue;
    ++carrying.strokes;
    carrying.broken += continuations(course.places, here) == 1 ? 0 : 1;
  }
  return carrying;
}

float median_shift_px(const StrokeCarrying& carrying) {
  if (carrying.shifts_px.empty()) return 0.0F;
  std::vector<float> sizes;
  for (const float shift : carrying.shifts_px) sizes.push_back(std::abs(shift));
  return median(std::move(sizes));
}

}  // namespace inkbench
