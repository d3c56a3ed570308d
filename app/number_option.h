// SPDX-License-Identifier: MIT
// What an option's number must be. CLI11's own checks let NaN pass, since it lies outside of no range.
#pragma once

#include <CLI/CLI.hpp>

namespace inkbench {

/// 0 or more, and finite.
CLI::Validator finite_not_negative();

}  // namespace inkbench
