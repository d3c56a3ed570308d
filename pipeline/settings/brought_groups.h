// SPDX-License-Identifier: MIT
// Parameter groups that settings hold for passes from elsewhere: a program that adds a pass of its own (or a
// test) brings the pass's group along, and it is listed, set, swept and kept in files as the others are.
#pragma once

#include <any>
#include <functional>
#include <vector>

#include "pipeline/params/description.h"

namespace inkbench {

class BroughtGroups {
 public:
  /// From now on all settings have a `Params`, under its description's group name. Before the first settings
  /// are read; a second time changes nothing.
  template <class Params>
  static void bring() {
    add_kind({&Params::description(), [] { return std::any(Params{}); },
              [](std::any& value) -> void* { return std::any_cast<Params>(&value); }});
  }

  template <class Params>
  const Params& get() const {
    return *static_cast<const Params*>(owner(place_of(Params::description())));
  }
  template <class Params>
  Params& get() {
    return *static_cast<Params*>(owner(place_of(Params::description())));
  }

  /// Calls `visit(description, owner)` for each; owners are const where `self` is.
  template <class Self, class Visit>
  static void visit(Self& self, const Visit& visit) {
    for (size_t i = 0; i < kinds().size(); ++i) visit(*kinds()[i].description, self.owner(i));
  }

 private:
  struct Kind {
    const Description* description;
    std::function<std::any()> make;
    std::function<void*(std::any&)> address;
  };
  static std::vector<Kind>& kinds();
  static void add_kind(const Kind& kind);
  static size_t place_of(const Description& description);
  const void* owner(size_t kind) const;
  void* owner(size_t kind);

  std::vector<std::any> values_;  ///< Those that were set; the others have their defaults.
};

}  // namespace inkbench
