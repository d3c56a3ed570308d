#include "pipeline/params/param.h"

#include "pipeline/params/toml_value.h"

namespace inkbench {

Value Param::value() const {
  const Value whole = field->get(owner);
  return component < 0 ? whole : Value(std::get<glm::vec3>(whole)[component]);
}

void Param::set(const Value& new_value, const std::string& where) const {
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

bool Param::overlaps(const Param& other) const {
  const bool one_is_whole = component < 0 || other.component < 0;
  return owner == other.owner && field == other.field && (one_is_whole || component == other.component);
}

}  // namespace inkbench
