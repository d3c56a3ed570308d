// SPDX-License-Identifier: MIT
#include "pipeline/params/glsl_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace inkbench {
namespace {

std::string_view glsl_type(FieldType type) {
  switch (type) {
    case FieldType::boolean:
    case FieldType::integer:
    case FieldType::choice:
      return "int";
    case FieldType::real:
      return "float";
    case FieldType::vector:
    case FieldType::colour:
      return "vec3";
    case FieldType::text:
    case FieldType::ramp:
      return "";
  }
  return "";
}

class Packer {
 public:
  template <class T>
  void scalar(T value) {
    append(&value, sizeof value, 4);
  }
  void vector(const glm::vec3& value) { append(&value, sizeof value, 16); }
  std::vector<uint8_t> finish() {
    bytes_.resize((bytes_.size() + 15) / 16 * 16);
    return std::move(bytes_);
  }

 private:
  void append(const void* data, size_t size, size_t alignment) {
    const size_t offset = (bytes_.size() + alignment - 1) / alignment * alignment;
    bytes_.resize(offset + size);
    std::memcpy(bytes_.data() + offset, data, size);
  }
  std::vector<uint8_t> bytes_;
};

int choice_index(const Field& field, const std::string& name) {
  return static_cast<int>(std::find(field.choices.begin(), field.choices.end(), name) -
                          field.choices.begin());
}

}  // namespace

std::string glsl_members(const Description& description) {
  std::string text;
  for (const Field& field : description.fields) {
    const std::string_view type = glsl_type(field.type);
    if (!type.empty()) text += fmt::format("  {} {};\n", type, field.name);
  }
  return text;
}

std::string glsl_struct(const Description& description, const std::string& name) {
  return "struct " + name + " {\n" + glsl_members(description) + "};\n";
}

std::string glsl_uniform_block(const Description& description, const std::string& name) {
  return fmt::format("layout(std140) uniform {}_block {{\n{}}} {};\n", name, glsl_members(description), name);
}

std::string glsl_choices(const Description& description, const std::string& prefix) {
  std::string text;
  for (const Field& field : description.fields) {
    for (size_t i = 0; i < field.choices.size(); ++i) {
      text += fmt::format("const int {}_{}_{} = {};\n", prefix, field.name, field.choices[i], i);
    }
  }
  return text;
}

std::vector<uint8_t> pack_std140(const Description& description, const void* owner) {
  Packer packer;
  for (const Field& field : description.fields) {
    if (glsl_type(field.type).empty()) continue;
    const Value value = field.get(owner);
    if (const auto* boolean = std::get_if<bool>(&value)) packer.scalar(static_cast<int>(*boolean));
    if (const auto* integer = std::get_if<int>(&value)) packer.scalar(*integer);
    if (const auto* real = std::get_if<float>(&value)) packer.scalar(*real);
    if (const auto* vector = std::get_if<glm::vec3>(&value)) packer.vector(*vector);
    if (const auto* name = std::get_if<std::string>(&value)) packer.scalar(choice_index(field, *name));
  }
  return packer.finish();
}

size_t std140_size(const Description& description) {
  size_t end = 0;
  for (const Field& field : description.fields) {
    const std::string_view type = glsl_type(field.type);
    if (type.empty()) continue;
    const size_t alignment = type == "vec3" ? 16 : 4;
    end = (end + alignment - 1) / alignment * alignment + (type == "vec3" ? 12 : 4);
  }
  return (end + 15) / 16 * 16;
}

}  // namespace inkbench
