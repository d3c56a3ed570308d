// SPDX-License-Identifier: MIT
// A number to drag, type or reset: a bar filled up to the value on its scale. In: the number and its
// description. Out: what the person did with it.
#pragma once

#include <optional>
#include <string>

#include "app/workbench/fit_result.h"
#include "pipeline/params/description.h"

namespace inkbench {

struct BarResult {
  bool pressed = false;   ///< Dragging begins.
  bool released = false;  ///< Dragging ends.
  bool given_up = false;  ///< It ends by Esc; `value` is what it was before.
  bool dragged = false;   ///< `value` is another one.
  bool reset = false;     ///< Right click.
  double value = 0.0;
  std::string typed;  ///< Not empty: what was typed and confirmed.
};

/// `id` must be unique in its window. Dragging sets values of the useful range in sensible steps, finer with
/// Shift; Ctrl and click types any number. What edits the document takes its edit back itself on Esc. `heat`,
/// where it is known, glows behind the values that are good.
BarResult value_bar(const char* id, double value, const Field& field, float width,
                    const ValueHeat* heat = nullptr);

/// What the person made of the bar: the value dragged to, or what was typed where that is a finite number.
std::optional<double> entered(const BarResult& bar);

/// The number as people read it: the shortest text, at most five digits.
std::string number_text(double value, bool whole);

/// A value of the useful range at a share of the bar, in sensible steps.
double value_at(const Field& field, double share, bool fine);

/// Where on the bar a value is, 0 to 1.
double share_of(const Field& field, double value);

}  // namespace inkbench
