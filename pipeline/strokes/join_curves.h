// SPDX-License-Identifier: MIT
// Which curves one stroke draws. In: the curves of a view. Out: paths, each as long as a pen would stay on
// the paper.
#pragma once

#include <vector>

#include "pipeline/settings/stroke_params.h"
#include "pipeline/strokes/stroke_path.h"

namespace inkbench {

/// Curves of one chain that go on in another class and lie under equally many surfaces make one path. Curves
/// whose class has no width make none, and covered ones only with `with_hidden`. Paths are in the order of
/// the curves' list.
std::vector<StrokePath> join_curves(const Curves& curves, const StrokeClasses& classes, bool with_hidden);

}  // namespace inkbench
