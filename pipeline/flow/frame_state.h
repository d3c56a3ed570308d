// SPDX-License-Identifier: MIT
// What a frame is: settings, and the key of each node's value under them, worked out once; perhaps the frame
// before.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "pipeline/base/key.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

struct FrameState {
  Settings settings;
  std::vector<Key> keys;                       ///< By node.
  std::shared_ptr<const FrameState> previous;  ///< Null where there is none, or no node looks at it.

  FrameState(Settings of, std::shared_ptr<const FrameState> before)
      : settings(std::move(of)), previous(std::move(before)) {}
  FrameState(const FrameState&) = delete;
  FrameState& operator=(const FrameState&) = delete;
  /// One after the other: a film's chain of frames would be too deep for a recursion.
  ~FrameState() {
    std::shared_ptr<const FrameState> next = std::move(previous);
    while (next && next.use_count() == 1)
      next = std::exchange(const_cast<FrameState&>(*next).previous, nullptr);
  }
};

}  // namespace inkbench
