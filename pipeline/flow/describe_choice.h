// SPDX-License-Identifier: MIT
// A choice among passes whose values are of one type, by the settings: a node that hands one of them on, key
// and all, and never runs the others:
//
//   struct FoundEdges {
//     using Value = Texture;
//     static const PassKind& kind();
//     static size_t chosen(const Settings& settings);  // the place in the list below
//   };
//   describe_choice<FoundEdges, PaperStrengthPass, LaplacianPass>("edges", "edges", {shows(...)});
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "pipeline/flow/describe_pass.h"

namespace inkbench {

template <class Tag, size_t kCount>
class ChoiceNode final : public Node<typename Tag::Value> {
 public:
  using Value = typename Tag::Value;
  using Alternatives = std::array<Node<Value>*, kCount>;

  ChoiceNode(std::string_view name, const Flow& flow, std::vector<ShownBuffer<Value>> shown,
             Alternatives alternatives)
      : Node<Value>(name, 0, flow.nodes().size()), shown_(std::move(shown)), alternatives_(alternatives) {}

  Key key(const FrameState& frame) const override { return frame.keys[chosen(frame).index()]; }
  std::shared_ptr<const Value> get(const FrameState& frame) override { return chosen(frame).get(frame); }
  Shown show(const FrameState& frame, BufferName buffer) override {
    for (const ShownBuffer<Value>& shown : shown_) {
      if (shown.buffer == buffer) return shown.show(get(frame));
    }
    return {};
  }
  /// It runs nothing.
  StageCount count() const override { return {}; }
  void forget() override {}
  void keep_frames(size_t count) override {
    for (Node<Value>* node : alternatives_) node->keep_frames(count);
  }
  bool looks_back() const override { return false; }
  std::vector<Program*> programs() override { return {}; }

 private:
  Node<Value>& chosen(const FrameState& frame) const {
    return *alternatives_.at(Tag::chosen(frame.settings));
  }

  std::vector<ShownBuffer<Value>> shown_;
  Alternatives alternatives_;
};

/// `group`: that of the parameter that chooses.
template <class Tag, class... Passes>
PassKind describe_choice(std::string_view name, std::string_view group,
                         std::vector<ShownBuffer<typename Tag::Value>> shown) {
  PassKind kind{.name = name, .cost = 0};
  for (const auto& buffer : shown) kind.buffers.push_back(buffer.buffer);
  kind.inputs.push_back({group});
  (kind.inputs.push_back({"", [] { return Passes::kind().name; }}), ...);
  kind.add_node = [=](Flow& flow) {
    using Made = ChoiceNode<Tag, sizeof...(Passes)>;
    flow.add_node(typeid(Tag), std::make_unique<Made>(name, flow, shown,
                                                      typename Made::Alternatives{&flow.node<Passes>()...}));
  };
  return kind;
}

}  // namespace inkbench
