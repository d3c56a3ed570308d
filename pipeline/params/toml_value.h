// SPDX-License-Identifier: MIT
// From TOML to a parameter's value, and the one check of a value against its description.
#pragma once

#include <string>

#include "pipeline/params/param.h"
#include "pipeline/params/toml_document.h"

namespace inkbench {

/// The node as a value of the field's type (`component`: of one of its components). A number stands for three
/// equal ones in a vector; a colour also reads "#rrggbb". Relative paths are resolved against `folder`.
/// Errors (input): another type, naming `where`, the key and what is needed.
Value value_from_toml(const Param& param, const TomlNode& node, const std::string& where,
                      const std::string& folder);

/// The same from a command line's text: TOML syntax, or a bare word, or numbers with commas.
Value value_from_text(const Param& param, const std::string& text, const std::string& where);

/// Errors (input): a number outside the hard limits or not finite, a name that is no choice, ramp stops out
/// of order.
void check_value(const Field& field, const std::string& key, const Value& value, const std::string& where);

/// "a number from 1e-06 to 1", "one of: box, sphere, ...": what the field accepts.
std::string accepted(const Field& field, int component);

}  // namespace inkbench
