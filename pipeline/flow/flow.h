// SPDX-License-Identifier: MIT
// The nodes of one pipeline, in an order in which each stands after those it takes values from, and what they
// share.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <typeindex>
#include <vector>

#include "pipeline/flow/node.h"
#include "pipeline/gl/shader_source.h"

namespace inkbench {

class Flow;

/// What a pass takes, for people: another pass's value, or a group of parameters.
struct PassInput {
  std::string_view group;                ///< "combine"; empty where it is a pass.
  std::string_view (*pass)() = nullptr;  ///< Its name. A function, since passes are described in any order.
  bool is_past = false;                  ///< Of the frame before.
};

/// What a pass is, once. Made by `describe_pass` beside the pass.
struct PassKind {
  std::string_view name;  ///< "combine": in counts, timings, keys.
  int cost = 0;           ///< Of running it, as a rough share of a frame's 40; only the order matters.
  std::vector<BufferName> buffers;  ///< What of its value people can see.
  std::vector<PassInput> inputs;    ///< What it takes.
  void (*bring)() = nullptr;  ///< Its own parameter group into all settings; null: the settings have it.
  std::function<void(Flow& flow)> add_node;
};

class Flow {
 public:
  explicit Flow(GeneratedSources generated) : generated_(std::move(generated)) {}

  /// Adds the pass's node; those whose values it takes must be there.
  void add(const PassKind& kind);

  const std::vector<std::unique_ptr<NodeBase>>& nodes() const { return nodes_; }
  /// The node that gives the buffer. There is one.
  NodeBase& node_of(BufferName buffer) const { return *buffers_.at(buffer); }

  /// The node of the pass `Tag`. Only while nodes are made, and from code that names the pass.
  template <class Tag>
  Node<typename Tag::Value>& node() const {
    return *static_cast<Node<typename Tag::Value>*>(tagged_.at(typeid(Tag)));
  }

  template <class Tag>
  bool has() const {
    return tagged_.contains(typeid(Tag));
  }

  /// What nodes share, one of each type: made when first asked for (of this flow, of the generated sources,
  /// or of nothing), or given by `share`.
  template <class T>
  T& shared() {
    std::shared_ptr<void> held = shared_[typeid(T)];
    if (!held) {
      if constexpr (std::is_constructible_v<T, Flow&>) {
        held = std::make_shared<T>(*this);
      } else if constexpr (std::is_constructible_v<T, const GeneratedSources&>) {
        held = std::make_shared<T>(generated_);
      } else {
        held = std::make_shared<T>();
      }
    }
    shared_[typeid(T)] = held;
    return *static_cast<T*>(held.get());
  }
  template <class T>
  void share(std::shared_ptr<T> thing) {
    shared_[typeid(T)] = std::move(thing);
  }
  template <class T>
  std::shared_ptr<T> sharing() {
    shared<T>();
    return std::static_pointer_cast<T>(shared_.at(typeid(T)));
  }

  const GeneratedSources& generated() const { return generated_; }
  PassObserver* observer() const { return observer_; }
  void observe(PassObserver* observer) { observer_ = observer; }
  bool looks_back() const;

  /// Called by `PassKind::add_node`.
  void add_node(std::type_index tag, std::unique_ptr<NodeBase> node);

 private:
  GeneratedSources generated_;
  std::map<std::type_index, std::shared_ptr<void>> shared_;  ///< Outlives the nodes.
  std::vector<std::unique_ptr<NodeBase>> nodes_;
  std::map<std::type_index, NodeBase*> tagged_;
  std::map<BufferName, NodeBase*> buffers_;
  PassObserver* observer_ = nullptr;
};

/// GLSL of the uniform blocks and structs, generated from the parameters' descriptions:
/// "generated/combine.glsl" for every group that there is once, "generated/light.glsl" and
/// "generated/material.glsl" for lists.
GeneratedSources generated_sources();

}  // namespace inkbench
