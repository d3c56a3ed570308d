// SPDX-License-Identifier: MIT
// Where each widget of the last frame is, by its name: what lets a test press a button without knowing the
// layout. Kept only when asked for.
#pragma once

#include <map>
#include <string>

namespace inkbench {

struct UiRect {
  float left = 0, top = 0, right = 0, bottom = 0;
  bool operator==(const UiRect&) const = default;
};

class UiMap {
 public:
  void enable() { enabled_ = true; }
  void begin_frame() { rects_.clear(); }
  /// Names the rectangle of ImGui's last item, as far as it is seen.
  void mark_item(const std::string& name);
  void mark(const std::string& name, const UiRect& rect);
  const std::map<std::string, UiRect>& rects() const { return rects_; }

  /// Presses of the Pause key: a test that sees its own knows that all before it is done.
  long pauses = 0;

 private:
  bool enabled_ = false;
  std::map<std::string, UiRect> rects_;
};

}  // namespace inkbench
