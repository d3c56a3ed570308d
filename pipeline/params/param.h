// A parameter inside some settings: its key, its description and where its value is.
#pragma once

#include <string>

#include "pipeline/params/description.h"

namespace inkbench {

/// One described struct inside some settings: `prefix` is its key so far ("combine",
/// "model.rabbit.material").
struct ParamGroup {
  std::string prefix;
  const Description* description = nullptr;
  void* owner = nullptr;
};

/// Whether a field of the group has an effect now: its `matters_when`, looked up among its siblings.
bool matters(const ParamGroup& group, const Field& field);

/// Valid while the settings live and keep their models and lights.
struct Param {
  std::string key;  ///< "combine.k_depth", "model.rabbit.position", "camera.eye.x".
  const Field* field = nullptr;
  void* owner = nullptr;
  int component = -1;  ///< 0 to 2 when the key names one component of a vector.

  Value value() const;
  /// Errors (input), all naming `where` and the key: out of range, not one of the choices.
  void set(const Value& value, const std::string& where) const;
  /// Whether setting one changes the other: the same parameter (".x" is ".r"), or a vector and its component.
  bool overlaps(const Param& other) const;
  /// Whether its value is one number: an integer, a real one or a component of a vector.
  bool is_number() const;
};

}  // namespace inkbench
