// SPDX-License-Identifier: MIT
// A node's memory: the values that it made last, each with the key of all that decided it. Same key: reuse.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "pipeline/base/key.h"
#include "pipeline/flow/stage.h"

namespace inkbench {

template <class Value>
class Memory {
 public:
  /// The value of that key, or null; counted as a reuse.
  std::shared_ptr<const Value> find(const Key& key) {
    const auto found =
        std::find_if(held_.begin(), held_.end(), [&](const Held& held) { return held.key == key; });
    if (found == held_.end()) return nullptr;
    std::rotate(found, found + 1, held_.end());  // the newest is last
    ++count_.reuses;
    return held_.back().value;
  }

  /// Forgets the value that was found last, which is no reuse then.
  void drop_found() {
    held_.pop_back();
    --count_.reuses;
  }

  /// Lets the oldest value go where there is no room, so that the next one can use its memory.
  void make_room() {
    if (held_.size() >= capacity_) held_.erase(held_.begin());
  }

  std::shared_ptr<const Value> keep(const Key& key, Value value) {
    held_.push_back({key, std::make_shared<const Value>(std::move(value))});
    ++count_.runs;
    return held_.back().value;
  }

  void forget() { held_.clear(); }
  void set_capacity(size_t capacity) { capacity_ = std::max(capacity_, capacity); }
  const StageCount& count() const { return count_; }

 private:
  struct Held {
    Key key;
    std::shared_ptr<const Value> value;
  };
  std::vector<Held> held_;
  size_t capacity_ = 1;
  StageCount count_;
};

}  // namespace inkbench
