// SPDX-License-Identifier: MIT
#include "pipeline/base/key.h"

#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <utility>

namespace inkbench {
namespace {

constexpr Uint128 kPrime = (static_cast<Uint128>(0x0000000001000000ULL) << 64) | 0x13bULL;

Uint128 fold(Uint128 state, std::span<const uint8_t> bytes) {
  // Eight bytes a step: FNV's mixing per word is enough here and keeps million-face meshes cheap.
  while (bytes.size() >= 8) {
    uint64_t word = 0;
    std::memcpy(&word, bytes.data(), 8);
    state = (state ^ word) * kPrime;
    state ^= state >> 67;
    bytes = bytes.subspan(8);
  }
  for (const uint8_t byte : bytes) state = (state ^ byte) * kPrime;
  return state;
}

}  // namespace

std::string Key::text() const {
  return fmt::format("{:016x}{:016x}", high, low);
}

KeyBuilder& KeyBuilder::add_bytes(std::span<const uint8_t> bytes) {
  const uint64_t size = bytes.size();
  uint8_t prefix[8];
  std::memcpy(prefix, &size, 8);
  state_ = fold(fold(state_, prefix), bytes);
  return *this;
}

std::optional<Key> key_from(std::string_view text) {
  constexpr size_t kDigits = 16;
  if (text.size() != 2 * kDigits) return std::nullopt;
  Key key;
  for (const auto& [part, from] : {std::pair(&key.high, text.data()), {&key.low, text.data() + kDigits}}) {
    const auto [end, error] = std::from_chars(from, from + kDigits, *part, 16);
    if (error != std::errc() || end != from + kDigits) return std::nullopt;
  }
  return key;
}

KeyBuilder& KeyBuilder::add(std::string_view part) {
  return add_bytes({reinterpret_cast<const uint8_t*>(part.data()), part.size()});
}

KeyBuilder& KeyBuilder::add(const Key& key) {
  return add(key.text());
}

Key KeyBuilder::key() const {
  return {static_cast<uint64_t>(state_ >> 64), static_cast<uint64_t>(state_)};
}

}  // namespace inkbench
