// SPDX-License-Identifier: MIT
// What a search leaves as data: every candidate, the box, the profiles, the tuned values as a preset. In: a
// spec and its result. Out: texts of files.
#pragma once

#include <string>

#include "studies/tuning/tune_spec.h"

namespace inkbench {

/// trace.csv: a row for each candidate in the order in which they were looked at: its stage, its values, what
/// the objective and each of its measures came to, the best objective so far.
std::string trace_csv(const TuneSpec& spec, const TuneResult& result);

/// box.csv: the even cover, a row for each point: its values and the objective.
std::string box_csv(const TuneSpec& spec, const TuneResult& result);

/// profiles.csv: each searched number moved alone, from the default and from the tuned values: `parameter`,
/// `from`, `value`, `objective`.
std::string profiles_csv(const TuneResult& result);

/// A scene file of the base's own scene with the tuned values: `inkbench render --scene`, studies and the
/// window read it.
std::string tuned_preset(const TuneSpec& spec, const TuneResult& result);

/// "0.876"; "-" where the drawing could not be made; with what it misses where limits are not kept.
std::string score_text(const Score& score);

}  // namespace inkbench
