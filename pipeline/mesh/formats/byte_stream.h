// SPDX-License-Identifier: MIT
// Values and arrays as flat bytes, to cross the pipe from a reading child process. Plain values go as they
// lie in memory, arrays and texts after their length.
#pragma once

#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "pipeline/base/error.h"
#include "pipeline/mesh/formats/isolated_call.h"

namespace inkbench {

class ByteWriter {
 public:
  explicit ByteWriter(const ByteSink& sink) : sink_(sink) {}

  template <class T>
  void value(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    sink_({reinterpret_cast<const uint8_t*>(&value), sizeof value});
  }
  template <class Array>
  void array(const Array& array) {
    static_assert(std::is_trivially_copyable_v<typename Array::value_type>);
    value(static_cast<uint64_t>(array.size()));
    sink_(
        {reinterpret_cast<const uint8_t*>(array.data()), array.size() * sizeof(typename Array::value_type)});
  }
  /// `write` is called for each item.
  template <class T, class Write>
  void list(const std::vector<T>& items, const Write& write) {
    value(static_cast<uint64_t>(items.size()));
    for (const T& item : items) write(item);
  }

 private:
  const ByteSink& sink_;
};

/// The counterpart. Errors (work): bytes that no `ByteWriter` wrote.
class ByteReader {
 public:
  explicit ByteReader(std::span<const uint8_t> bytes) : bytes_(bytes) {}

  template <class T>
  void value(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::span<const uint8_t> bytes = take(1, sizeof value);
    std::memcpy(&value, bytes.data(), sizeof value);
  }
  void value(bool& value) { value = take(1, 1)[0] != 0; }
  template <class Array>
  void array(Array& array) {
    using Item = typename Array::value_type;
    const std::span<const uint8_t> bytes = take(length(), sizeof(Item));
    array.resize(bytes.size() / sizeof(Item));
    if (!bytes.empty()) std::memcpy(array.data(), bytes.data(), bytes.size());
  }
  /// `read` fills each item, which takes one byte at least.
  template <class T, class Read>
  void list(std::vector<T>& items, const Read& read) {
    const uint64_t count = length();
    if (count > bytes_.size()) throw damaged();
    for (uint64_t i = 0; i < count; ++i) read(items.emplace_back());
  }
  void check_all_taken() const {
    if (!bytes_.empty()) throw damaged();
  }
  static Error damaged() { return work_error("", "the mesh reader's answer is damaged"); }

 private:
  uint64_t length() {
    uint64_t length = 0;
    value(length);
    return length;
  }
  std::span<const uint8_t> take(uint64_t count, size_t item_bytes) {
    if (count > bytes_.size() / item_bytes) throw damaged();
    const std::span<const uint8_t> taken = bytes_.first(count * item_bytes);
    bytes_ = bytes_.subspan(taken.size());
    return taken;
  }

  std::span<const uint8_t> bytes_;
};

}  // namespace inkbench
