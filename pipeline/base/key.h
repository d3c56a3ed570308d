// SPDX-License-Identifier: MIT
// Cache keys: 128-bit FNV-1a over everything that decides a stage's output. Same key, same output.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace inkbench {

struct Key {
  uint64_t high = 0;
  uint64_t low = 0;

  auto operator<=>(const Key&) const = default;
  /// 32 lower-case hexadecimal digits.
  std::string text() const;
};

__extension__ using Uint128 = unsigned __int128;

/// The key whose text that is; nothing where it is none.
std::optional<Key> key_from(std::string_view text);

/// Folds parts into a key. Each part is length-prefixed, so ("ab", "c") and ("a", "bc") differ.
class KeyBuilder {
 public:
  KeyBuilder& add(std::string_view part);
  KeyBuilder& add(const Key& key);
  KeyBuilder& add_bytes(std::span<const uint8_t> bytes);
  Key key() const;

 private:
  Uint128 state_ = (static_cast<Uint128>(0x6c62272e07bb0142ULL) << 64) | 0x62b821756295c58dULL;
};

}  // namespace inkbench
