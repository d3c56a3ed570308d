// SPDX-License-Identifier: MIT
// How a pass says what it is, beside its class, in one call:
//
//   const PassKind& CombinePass::kind() {
//     static const PassKind kKind =
//         describe_pass<CombinePass>("combine", 2, {shows(BufferName::combined_edges)},
//         group<&Settings::combine>(),
//                                    value_of<RangePass>(), part<&Settings::image,
//                                    &ImageParams::precision>());
//     return kKind;
//   }
//
// `run` is called with what the inputs give, in their order. A pass class has `using Value`, one `run`, and
// perhaps a `program()`, or several `programs()`; it is made once for a pipeline. Two nodes may run one
// class: a tag names `Pass` and `Value`. A pass that at times hands its first input on says when by `static
// bool hands_on(const Settings&)`, and what by `handed`. One whose value may lack parts that only some
// settings read says so by `static bool lacks_part(const Value& held, const Settings&)`: then it runs again,
// under the same key.
#pragma once

#include <tuple>
#include <type_traits>
#include <utility>

#include "pipeline/base/stop.h"
#include "pipeline/flow/inputs.h"

namespace inkbench {

/// How a buffer is seen in the value of its pass.
template <class Value>
struct ShownBuffer {
  BufferName buffer;
  std::function<Shown(const std::shared_ptr<const Value>&)> show;
};

/// The value is the buffer's texture.
inline ShownBuffer<Texture> shows(BufferName buffer) {
  return {buffer, [](const std::shared_ptr<const Texture>& value) {
            return Shown{value, value.get(), {}, {}};
          }};
}

/// A member of the value is: `shows<&GBuffer::object_id>(BufferName::object_id)`.
template <class Value>
ShownBuffer<Value> shows(BufferName buffer, Texture Value::*member) {
  return {buffer, [member](const std::shared_ptr<const Value>& value) {
            return Shown{value, &(*value.*member), {}, {}};
          }};
}

/// The value is no texture: what draws it, and what gives its raw values.
template <class Value>
ShownBuffer<Value> shows_drawing(BufferName buffer, Picture (*picture)(const Value&),
                                 Image (*raw)(const Value&)) {
  return {buffer, [=](const std::shared_ptr<const Value>& value) {
            return Shown{value, nullptr, [=] { return picture(*value); }, [=] { return raw(*value); }};
          }};
}

namespace detail {

template <class Tag>
struct PassOf {
  using type = Tag;
};
template <class Tag>
requires requires {
  typename Tag::Pass;
}
struct PassOf<Tag> {
  using type = typename Tag::Pass;
};

template <class Input>
constexpr bool looks_back() {
  return requires {
    Input::kLooksBack;
  };
}

}  // namespace detail

template <class Tag, class... Inputs>
class PassNode final : public Node<typename Tag::Value> {
 public:
  using Value = typename Tag::Value;
  using Pass = typename detail::PassOf<Tag>::type;

  PassNode(std::string_view name, int cost, Flow& flow, std::vector<ShownBuffer<Value>> shown,
           Inputs... inputs)
      : Node<Value>(name, cost, flow.nodes().size()),
        flow_(flow),
        pass_(flow.shared<Pass>()),
        inputs_(std::move(inputs)...),
        shown_(std::move(shown)) {}

  Key key(const FrameState& frame) const override {
    if (const GivenValue* given = frame.given_for(typeid(Tag))) return given->key;
    if constexpr (kHandsOn) {
      if (Tag::hands_on(frame.settings)) return frame.keys[std::get<0>(inputs_).node->index()];
    }
    KeyBuilder key;
    key.add(this->name());
    for (const Program* program : programs_of(pass_)) key.add(program->key());
    std::apply([&](const auto&... input) { (input.fold(key, frame), ...); }, inputs_);
    return key.key();
  }

  std::shared_ptr<const Value> get(const FrameState& frame) override {
    if (const GivenValue* given = frame.given_for(typeid(Tag)))
      return std::static_pointer_cast<const Value>(given->value);
    if constexpr (kHandsOn) {
      if (Tag::hands_on(frame.settings)) {
        const auto first = std::get<0>(inputs_).get(frame);
        return {first, &Tag::handed(*first)};
      }
    }
    const Key& key = frame.keys[this->index()];
    if (auto held = memory_.find(key)) {
      if (!lacks_part(*held, frame.settings)) return held;
      memory_.drop_found();
    }
    // All inputs before the pass begins: passes do not lie within each other.
    const auto values = std::apply(
        [&](const auto&... input) { return std::tuple<decltype(input.get(frame))...>{input.get(frame)...}; },
        inputs_);
    stop_if_asked();
    memory_.make_room();
    const PassScope scope(flow_.observer(), this->name());
    return memory_.keep(
        key, std::apply([&](const auto&... value) { return pass_.run(as_argument(value)...); }, values));
  }

  Shown show(const FrameState& frame, BufferName buffer) override {
    for (const ShownBuffer<Value>& shown : shown_) {
      if (shown.buffer == buffer) return shown.show(get(frame));
    }
    return {};
  }

  StageCount count() const override { return memory_.count(); }
  void forget() override { memory_.forget(); }
  void keep_frames(size_t count) override { memory_.set_capacity(count); }
  bool looks_back() const override { return (detail::looks_back<Inputs>() || ...); }
  std::vector<Program*> programs() override { return programs_of(pass_); }

 private:
  static std::vector<Program*> programs_of(Pass& pass) {
    if constexpr (requires { pass.programs(); })
      return pass.programs();
    else if constexpr (requires { pass.program(); })
      return {&pass.program()};
    else
      return {};
  }
  static constexpr bool kHandsOn = requires(const Settings& settings) { Tag::hands_on(settings); };

  static bool lacks_part([[maybe_unused]] const Value& held, [[maybe_unused]] const Settings& settings) {
    if constexpr (requires { Tag::lacks_part(held, settings); })
      return Tag::lacks_part(held, settings);
    else
      return false;
  }

  Flow& flow_;
  Pass& pass_;
  std::tuple<Inputs...> inputs_;
  std::vector<ShownBuffer<Value>> shown_;
  Memory<Value> memory_;
};

template <class Tag, class... Inputs>
PassKind describe_pass(std::string_view name, int cost, std::vector<ShownBuffer<typename Tag::Value>> shown,
                       Inputs... inputs) {
  PassKind kind{.name = name, .cost = cost};
  for (const auto& buffer : shown) kind.buffers.push_back(buffer.buffer);
  const auto tell = [&](const std::vector<PassInput>& told) {
    kind.inputs.insert(kind.inputs.end(), told.begin(), told.end());
  };
  (tell(inputs.told()), ...);
  if constexpr (requires { Tag::handed_by(); }) tell({Tag::handed_by()});
  kind.add_node = [=](Flow& flow) {
    using Made = PassNode<Tag, decltype(inputs.bind(flow))...>;
    flow.add_node(typeid(Tag), std::make_unique<Made>(name, cost, flow, shown, inputs.bind(flow)...));
  };
  return kind;
}

}  // namespace inkbench
