// SPDX-License-Identifier: MIT
// What a pass takes: parameter groups, single parameters, other passes' values, the frame before. Each says
// both what it adds to the pass's key and what the pass is run with, so that these cannot differ. An input of
// another kind is a struct with `bind`, `fold`, `get` and `told` like those here.
#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "pipeline/flow/flow.h"

namespace inkbench {

/// One of the settings' groups: `group<&Settings::combine>()`. Run with: const CombineParams&.
template <auto kGroup>
struct GroupInput {
  GroupInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() {
    return {{std::remove_cvref_t<decltype(std::declval<Settings>().*kGroup)>::description().group}};
  }
  void fold(KeyBuilder& key, const FrameState& frame) const { key.add(group_text(frame.settings.*kGroup)); }
  const auto& get(const FrameState& frame) const { return frame.settings.*kGroup; }
};
template <auto kGroup>
constexpr GroupInput<kGroup> group() {
  return {};
}

/// A group that the pass brings. Run with: const Params&.
template <class Params>
struct BroughtInput {
  BroughtInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() { return {{Params::description().group}}; }
  void fold(KeyBuilder& key, const FrameState& frame) const { key.add(group_text(get(frame))); }
  const Params& get(const FrameState& frame) const { return frame.settings.brought.template get<Params>(); }
};
template <class Params>
constexpr BroughtInput<Params> brought() {
  return {};
}

/// One parameter of a group: `part<&Settings::image, &ImageParams::precision>()`. Run with: its value.
template <auto kGroup, auto kMember>
struct PartInput {
  PartInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() { return GroupInput<kGroup>::told(); }
  void fold(KeyBuilder& key, const FrameState& frame) const {
    const auto value = get(frame);
    key.add_bytes({reinterpret_cast<const uint8_t*>(&value), sizeof value});
  }
  auto get(const FrameState& frame) const { return frame.settings.*kGroup.*kMember; }
};
template <auto kGroup, auto kMember>
constexpr PartInput<kGroup, kMember> part() {
  return {};
}

/// What follows from the settings: `derived<is_papers_ink>(EdgesParams::description)`, with a function of
/// them to a plain value and the group of what it looks at. Run with: its value.
template <auto kFunction>
struct DerivedInput {
  std::string_view group;

  DerivedInput bind(Flow&) const { return *this; }
  std::vector<PassInput> told() const { return {{group}}; }
  void fold(KeyBuilder& key, const FrameState& frame) const {
    const auto value = get(frame);
    static_assert(std::is_trivially_copyable_v<decltype(value)>);
    key.add_bytes({reinterpret_cast<const uint8_t*>(&value), sizeof value});
  }
  auto get(const FrameState& frame) const { return kFunction(frame.settings); }
};
template <auto kFunction>
DerivedInput<kFunction> derived(const Description& (*group)()) {
  return {group().group};
}

/// Which part of the image is drawn. Run with: const ImageWindow&.
struct WindowInput {
  WindowInput bind(Flow&) const { return *this; }
  static std::vector<PassInput> told() { return GroupInput<&Settings::image>::told(); }
  void fold(KeyBuilder& key, const FrameState& frame) const { key.add(key_text(frame.window)); }
  const ImageWindow& get(const FrameState& frame) const { return frame.window; }
};

/// Another pass's value. Run with: const Tag::Value&.
template <class Tag>
struct BoundValue {
  Node<typename Tag::Value>* node = nullptr;
  void fold(KeyBuilder& key, const FrameState& frame) const { key.add(frame.keys[node->index()]); }
  std::shared_ptr<const typename Tag::Value> get(const FrameState& frame) const { return node->get(frame); }
};
template <class Tag>
struct ValueInput {
  BoundValue<Tag> bind(Flow& flow) const { return {&flow.node<Tag>()}; }
  static std::vector<PassInput> told() {
    return {{"", [] { return Tag::kind().name; }}};
  }
};
template <class Tag>
constexpr ValueInput<Tag> value_of() {
  return {};
}

/// Another pass's value where the settings need it: `value_when<VisibleRangePass, needs_range>()`, with
/// `bool needs_range(const Settings&)`. Run with: const Tag::Value*, null where they do not.
template <class Tag>
struct NeededValue {
  std::shared_ptr<const typename Tag::Value> value;
};
template <class Tag, bool (*kIsNeeded)(const Settings&)>
struct BoundNeededValue {
  BoundValue<Tag> bound;
  void fold(KeyBuilder& key, const FrameState& frame) const {
    if (kIsNeeded(frame.settings)) return bound.fold(key, frame);
    key.add("not needed");
  }
  NeededValue<Tag> get(const FrameState& frame) const {
    return {kIsNeeded(frame.settings) ? bound.get(frame) : nullptr};
  }
};
template <class Tag, bool (*kIsNeeded)(const Settings&)>
struct NeededInput {
  BoundNeededValue<Tag, kIsNeeded> bind(Flow& flow) const { return {{&flow.node<Tag>()}}; }
  static std::vector<PassInput> told() { return ValueInput<Tag>::told(); }
};
template <class Tag, bool (*kIsNeeded)(const Settings&)>
constexpr NeededInput<Tag, kIsNeeded> value_when() {
  return {};
}

/// A pass's value in the frame before, its own among them: null where there is none. Run with: const
/// Tag::Value*.
template <class Tag>
struct PastValue {
  std::shared_ptr<const typename Tag::Value> value;
};
template <class Tag>
struct BoundPastValue {
  static constexpr bool kLooksBack = true;
  Flow* flow = nullptr;
  size_t index = 0;
  void fold(KeyBuilder& key, const FrameState& frame) const {
    key.add(frame.previous ? frame.previous->keys[index].text() : "no frame before");
  }
  PastValue<Tag> get(const FrameState& frame) const {
    Node<typename Tag::Value>& node = flow->node<Tag>();
    node.keep_frames(2);
    return {frame.previous ? node.get(*frame.previous) : nullptr};
  }
};
template <class Tag>
struct PastInput {
  static std::vector<PassInput> told() {
    return {{"", [] { return Tag::kind().name; }, true}};
  }
  /// A pass that is not there yet is the one that is being made.
  BoundPastValue<Tag> bind(Flow& flow) const {
    return {&flow, flow.has<Tag>() ? flow.node<Tag>().index() : flow.nodes().size()};
  }
};
template <class Tag>
constexpr PastInput<Tag> past_value_of() {
  return {};
}

/// What a pass is run with for what an input gives.
template <class T>
const T& as_argument(const std::shared_ptr<const T>& value) {
  return *value;
}
template <class Tag>
const typename Tag::Value* as_argument(const NeededValue<Tag>& needed) {
  return needed.value.get();
}
template <class Tag>
const typename Tag::Value* as_argument(const PastValue<Tag>& past) {
  return past.value.get();
}
template <class T>
const T& as_argument(const T& value) {
  return value;
}

}  // namespace inkbench
