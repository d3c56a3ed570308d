// SPDX-License-Identifier: MIT
#include "pipeline/params/param.h"

#include "pipeline/params/toml_value.h"

namespace inkbench {

template <class Owner>
Value ParamOf<Owner>::value() const {
  const Value whole = field->get(owner);
  return component < 0 ? whole : Value(std::get<glm::vec3>(whole)[component]);
}

template <class Owner>
void ParamOf<Owner>::set(const Value& new_value, const std::string& where) const
    requires(!std::is_const_v<Owner>) {
  if (component < 0) {
    check_value(*field, key, new_value, where);
    field->set(owner, new_value);
    return;
  }
  glm::vec3 whole = std::get<glm::vec3>(field->get(owner));
  whole[component] = std::get<float>(new_value);
  check_value(*field, key, whole, where);
  field->set(owner, whole);
}

template <class Owner>
bool ParamOf<Owner>::overlaps(const ParamOf& other) const {
  const bool one_is_whole = component < 0 || other.component < 0;
  return owner == other.owner && field == other.field && (one_is_whole || component == other.component);
}

template <class Owner>
bool ParamOf<Owner>::is_number() const {
  return component >= 0 || field->type == FieldType::integer || field->type == FieldType::real;
}

template struct ParamOf<void>;
// Member by member, since clang 14 would make `set` of it, too.
template Value ParamOf<const void>::value() const;
template bool ParamOf<const void>::overlaps(const ParamOf& other) const;
template bool ParamOf<const void>::is_number() const;

}  // namespace inkbench
