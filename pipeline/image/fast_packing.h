// SPDX-License-Identifier: MIT
// Bytes packed by ISA-L's DEFLATE, which takes flat pictures at gigabytes a second. In: bytes. Out: fewer
// bytes, and back.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace inkbench {

/// Packs what comes piece by piece into one stream. The same pieces give the same bytes on one machine;
/// another processor may pack in another way.
class FastPacker {
 public:
  enum class Frame { none, zlib };  ///< Whether a header and a check sum stand around the stream.

  explicit FastPacker(Frame frame);
  FastPacker(const FastPacker&) = delete;
  FastPacker& operator=(const FastPacker&) = delete;
  ~FastPacker();

  /// Appends to `packed` what is ready; with `at_end` all that is left.
  void add(std::span<const uint8_t> bytes, bool at_end, std::string& packed);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// `bytes` as one stream without a frame.
std::string fast_packed(std::span<const uint8_t> bytes);

/// What `fast_packed` packed: `size` bytes; nothing where `packed` is no stream of that many.
std::optional<std::vector<uint8_t>> unpacked(std::string_view packed, size_t size);

}  // namespace inkbench
