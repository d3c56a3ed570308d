// SPDX-License-Identifier: MIT
// One stage's memory: the last value and the key of all that decided it. Same key: reuse.
#pragma once

#include <optional>

#include "pipeline/base/key.h"

namespace inkbench {

struct StageCount {
  long runs = 0;    ///< Times the stage was computed.
  long reuses = 0;  ///< Times its value was asked for and still held.
};

template <class Value>
class Stage {
 public:
  /// The value for `key`, made by `make` unless it is held. If `make` throws, the stage holds nothing.
  template <class Make>
  const Value& get(const Key& key, Make&& make) {
    if (value_ && key_ == key) {
      ++count_.reuses;
      return *value_;
    }
    value_.reset();  // first, so that the new value can use the old one's memory
    value_.emplace(make());
    key_ = key;
    ++count_.runs;
    return *value_;
  }

  void forget() { value_.reset(); }

  const StageCount& count() const { return count_; }

 private:
  Key key_;
  std::optional<Value> value_;
  StageCount count_;
};

}  // namespace inkbench
