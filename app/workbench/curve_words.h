// SPDX-License-Identifier: MIT
// A curve in words, for people who point at it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/curves/curve.h"

namespace inkbench {

/// What it is and of which object, how long it is and what covers it, what lies behind it where it is an
/// outline, and how it ends: a line each. `object`: the name of what it belongs to; empty where none is
/// known.
std::vector<std::string> curve_words(const Curve& curve, std::string_view object);

}  // namespace inkbench
