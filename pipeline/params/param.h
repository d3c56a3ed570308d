// SPDX-License-Identifier: MIT
// A parameter inside some settings: its key, its description and where its value is. Settings that are only
// read give `Const...` ones.
#pragma once

#include <string>
#include <type_traits>

#include "pipeline/params/description.h"

namespace inkbench {

/// One described struct inside some settings: `prefix` is its key so far ("combine",
/// "model.rabbit.material"). `Owner` is void, or const void where it is only read.
template <class Owner>
struct ParamGroupOf {
  std::string prefix;
  const Description* description = nullptr;
  Owner* owner = nullptr;

  operator ParamGroupOf<const void>() const requires(!std::is_const_v<Owner>) {
    return {prefix, description, owner};
  }
};
using ParamGroup = ParamGroupOf<void>;
using ConstParamGroup = ParamGroupOf<const void>;

/// Valid while the settings live and keep their models and lights.
template <class Owner>
struct ParamOf {
  std::string key;  ///< "combine.k_depth", "model.rabbit.position", "camera.eye.x".
  const Field* field = nullptr;
  Owner* owner = nullptr;
  int component = -1;  ///< 0 to 2 when the key names one component of a vector.

  operator ParamOf<const void>() const requires(!std::is_const_v<Owner>) {
    return {key, field, owner, component};
  }

  Value value() const;
  /// Whether setting one changes the other: the same parameter (".x" is ".r"), or a vector and its component.
  bool overlaps(const ParamOf& other) const;
  /// Whether its value is one number: an integer, a real one or a component of a vector.
  bool is_number() const;
  /// Errors (input), all naming `where` and the key: out of range, not one of the choices.
  void set(const Value& value, const std::string& where) const requires(!std::is_const_v<Owner>);
};
using Param = ParamOf<void>;
using ConstParam = ParamOf<const void>;

extern template struct ParamOf<void>;

}  // namespace inkbench
