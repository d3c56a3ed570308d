// SPDX-License-Identifier: MIT
// A pass as a node of the flow: one name, inputs from which both its key and its run come, and the value that
// it made last. In: a frame. Out: the value under the frame's settings, made only if nothing holds it.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>

#include "pipeline/flow/buffer_name.h"
#include "pipeline/flow/frame_state.h"
#include "pipeline/flow/memory.h"
#include "pipeline/flow/pass_observer.h"
#include "pipeline/gl/program.h"
#include "pipeline/image/image.h"

namespace inkbench {

/// A buffer's value: a texture of which a picture can be made, or what makes its picture and its raw values.
struct Shown {
  std::shared_ptr<const void> held;  ///< Keeps the value alive.
  const Texture* texture = nullptr;
  std::function<Picture()> picture;  ///< Where there is no texture.
  std::function<Image()> raw;
};

class NodeBase {
 public:
  NodeBase(std::string_view name, int cost, size_t index) : name_(name), cost_(cost), index_(index) {}
  NodeBase(const NodeBase&) = delete;
  NodeBase& operator=(const NodeBase&) = delete;
  virtual ~NodeBase() = default;

  std::string_view name() const { return name_; }
  int cost() const { return cost_; }
  /// Its place among the flow's nodes, and that of its key in a frame.
  size_t index() const { return index_; }

  /// Decides the value; those of the nodes before it must be in the frame. Errors (input): a file that
  /// decides it cannot be read.
  virtual Key key(const FrameState& frame) const = 0;
  /// Of a buffer that it gives. Errors: as the pass.
  virtual Shown show(const FrameState& frame, BufferName buffer) = 0;
  virtual StageCount count() const = 0;
  virtual void forget() = 0;
  virtual std::vector<Program*> programs() = 0;
  virtual bool looks_back() const = 0;
  /// Holds the values of so many frames, where others look at earlier ones or frames take turns.
  virtual void keep_frames(size_t count) = 0;

 private:
  std::string_view name_;
  int cost_;
  size_t index_;
};

template <class Value>
class Node : public NodeBase {
 public:
  using NodeBase::NodeBase;
  virtual std::shared_ptr<const Value> get(const FrameState& frame) = 0;
};

}  // namespace inkbench
