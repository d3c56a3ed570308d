// SPDX-License-Identifier: MIT
// What a frame is: settings, and the key of each node's value under them, worked out once; perhaps the frame
// before, perhaps a part of the image, perhaps values that it was handed.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <typeindex>
#include <utility>
#include <vector>

#include "pipeline/base/key.h"
#include "pipeline/flow/image_window.h"
#include "pipeline/settings/settings.h"

namespace inkbench {

/// A node's value that a frame is handed instead of making it, with its key.
struct GivenValue {
  std::type_index tag;  ///< Of the pass.
  Key key;
  std::shared_ptr<const void> value;
};

struct FrameState {
  Settings settings;
  ImageWindow window;                          ///< What of the settings' image is drawn.
  std::vector<Key> keys;                       ///< By node.
  std::vector<GivenValue> given;               ///< Before the keys are worked out.
  std::shared_ptr<const FrameState> previous;  ///< Null where there is none, or no node looks at it.

  FrameState(Settings of, std::shared_ptr<const FrameState> before,
             const std::optional<ImageWindow>& part = std::nullopt)
      : settings(std::move(of)),
        window(part.value_or(whole_image(settings.image))),
        previous(std::move(before)) {}
  const GivenValue* given_for(std::type_index tag) const {
    const auto found =
        std::find_if(given.begin(), given.end(), [&](const GivenValue& value) { return value.tag == tag; });
    return found == given.end() ? nullptr : &*found;
  }

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
