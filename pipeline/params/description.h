// SPDX-License-Identifier: MIT
// One description per parameter, beside the struct that holds it: name, unit, limits, slider, help. Sliders,
// study keys, `--set`, TOML, validation, uniform blocks, cache keys and the docs table are visitors over it.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "pipeline/params/value.h"

namespace inkbench {

enum class FieldType { boolean, integer, real, vector, colour, choice, text, ramp };
enum class Scale { linear, log };

struct Limits {
  double low = 0.0;
  double high = 0.0;
};

/// What a description line says of a field.
struct FieldText {
  std::string_view name;        ///< Last part of the key: "k_depth".
  std::string_view help;        ///< One line.
  std::string_view unit;        ///< "deg", "px", "world units"; empty for plain numbers.
  Limits limits{};              ///< Hard limits, both allowed; each component of a vector.
  Limits slider{};              ///< The useful range; the hard limits where left out.
  Scale scale = Scale::linear;  ///< Of the slider, and of a sweep that does not say.
  bool is_path = false;     ///< A file's path: relative ones are resolved against the file that sets them.
  bool is_profile = false;  ///< Widths along a stroke, as `parse_profile` reads them.
  bool (*is_no_path)(std::string_view) =
      nullptr;                 ///< What such a field takes for something else than a path.
  std::string_view zero_text;  ///< "all": what a slider shows for 0, which stands beyond its largest value.
  /// "shape = torus", "edges.method = paper": what must be set for it to have an effect (params/condition.h).
  std::string_view matters_when;
};

/// A field with its type and its place in the struct, reached through `get` and `set`.
struct Field : FieldText {
  FieldType type{};
  std::span<const std::string_view> choices;  ///< Names in the enum's order; empty unless a choice.
  Value (*get)(const void* owner) = nullptr;
  void (*set)(void* owner, const Value& value) = nullptr;
};

/// All fields of one struct under their group's name ("combine").
struct Description {
  std::string_view group;
  std::string_view title;  ///< One line for people: "Combining the edges (3.4.4)".
  std::vector<Field> fields;
  std::string_view matters_when;  ///< Of all its fields, beside what each says; with whole keys.
};

/// Specialise for an enum that a parameter holds: `static constexpr std::array names{...}` in the enum's
/// order.
template <class Enum>
struct ChoiceNames;

namespace detail {

template <class T>
struct MemberOf;
template <class Owner, class Member>
struct MemberOf<Member Owner::*> {
  using owner = Owner;
  using member = Member;
};

template <auto kMember>
Value get_member(const void* owner) {
  using Of = MemberOf<decltype(kMember)>;
  const auto& member = static_cast<const typename Of::owner*>(owner)->*kMember;
  if constexpr (std::is_enum_v<typename Of::member>) {
    return std::string(ChoiceNames<typename Of::member>::names[static_cast<size_t>(member)]);
  } else {
    return member;
  }
}

template <auto kMember>
void set_member(void* owner, const Value& value) {
  using Of = MemberOf<decltype(kMember)>;
  auto& member = static_cast<typename Of::owner*>(owner)->*kMember;
  if constexpr (std::is_enum_v<typename Of::member>) {
    constexpr auto& kNames = ChoiceNames<typename Of::member>::names;
    for (size_t i = 0; i < kNames.size(); ++i) {
      if (kNames[i] == std::get<std::string>(value)) member = static_cast<typename Of::member>(i);
    }
  } else {
    member = std::get<typename Of::member>(value);
  }
}

template <class Member>
constexpr FieldType field_type() {
  if constexpr (std::is_same_v<Member, bool>) return FieldType::boolean;
  if constexpr (std::is_same_v<Member, int>) return FieldType::integer;
  if constexpr (std::is_same_v<Member, float>) return FieldType::real;
  if constexpr (std::is_same_v<Member, glm::vec3>) return FieldType::vector;
  if constexpr (std::is_same_v<Member, Ramp>) return FieldType::ramp;
  if constexpr (std::is_enum_v<Member>) return FieldType::choice;
  return FieldType::text;
}

}  // namespace detail

/// Describes one member: `field<&CombineParams::k_depth>({.name = "k_depth", ...})`.
template <auto kMember>
Field field(const FieldText& text) {
  using Member = typename detail::MemberOf<decltype(kMember)>::member;
  Field result{text};
  result.type = detail::field_type<Member>();
  if constexpr (std::is_enum_v<Member>) result.choices = ChoiceNames<Member>::names;
  if (result.slider.low == result.slider.high) result.slider = result.limits;
  result.get = detail::get_member<kMember>;
  result.set = detail::set_member<kMember>;
  return result;
}

/// The same for a vector that is a colour (edited with a colour picker, limits 0 to 1 unless given).
template <auto kMember>
Field colour_field(FieldText text) {
  if (text.limits.low == text.limits.high) text.limits = {0.0, 1.0};
  Field result = field<kMember>(text);
  result.type = FieldType::colour;
  return result;
}

/// "real", "vector", ...: the word that tables and errors use.
std::string_view type_name(FieldType type);

}  // namespace inkbench
