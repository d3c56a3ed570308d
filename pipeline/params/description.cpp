// SPDX-License-Identifier: MIT
#include "pipeline/params/description.h"

namespace inkbench {

std::string_view type_name(FieldType type) {
  constexpr std::array<std::string_view, 8> kNames{"true/false", "integer", "real", "vector",
                                                   "colour",     "choice",  "text", "ramp"};
  return kNames[static_cast<size_t>(type)];
}

}  // namespace inkbench
