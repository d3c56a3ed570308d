// SPDX-License-Identifier: MIT
#include "pipeline/image/fast_packing.h"

#include <isa-l/igzip_lib.h>

#include <array>
#include <cassert>

namespace inkbench {

struct FastPacker::State {
  isal_zstream stream;
  std::vector<uint8_t> level_buffer = std::vector<uint8_t>(ISAL_DEF_LVL1_DEFAULT);
};

FastPacker::FastPacker(Frame frame) : state_(std::make_unique<State>()) {
  isal_zstream& stream = state_->stream;
  isal_deflate_init(&stream);
  stream.level = 1;  // Level 0 packs a third less; 2 and 3 gain nothing on pictures.
  stream.level_buf = state_->level_buffer.data();
  stream.level_buf_size = static_cast<uint32_t>(state_->level_buffer.size());
  stream.gzip_flag = frame == Frame::zlib ? IGZIP_ZLIB : IGZIP_DEFLATE;
}

FastPacker::~FastPacker() = default;

void FastPacker::add(std::span<const uint8_t> bytes, bool at_end, std::string& packed) {
  isal_zstream& stream = state_->stream;
  std::array<uint8_t, 1 << 16> room;
  stream.next_in = const_cast<uint8_t*>(bytes.data());  // ISA-L only reads it
  stream.avail_in = static_cast<uint32_t>(bytes.size());
  stream.end_of_stream = at_end ? 1 : 0;
  do {
    stream.next_out = room.data();
    stream.avail_out = static_cast<uint32_t>(room.size());
    [[maybe_unused]] const int status = isal_deflate(&stream);
    assert(status == COMP_OK);
    packed.append(reinterpret_cast<const char*>(room.data()), room.size() - stream.avail_out);
  } while (stream.avail_out == 0);
}

std::string fast_packed(std::span<const uint8_t> bytes) {
  std::string packed;
  FastPacker(FastPacker::Frame::none).add(bytes, true, packed);
  return packed;
}

std::optional<std::vector<uint8_t>> unpacked(std::string_view packed, size_t size) {
  std::vector<uint8_t> bytes(size);
  inflate_state state;
  isal_inflate_init(&state);
  state.next_in = reinterpret_cast<uint8_t*>(const_cast<char*>(packed.data()));  // ISA-L only reads it
  state.avail_in = static_cast<uint32_t>(packed.size());
  state.next_out = bytes.data();
  state.avail_out = static_cast<uint32_t>(size);
  const int status = isal_inflate_stateless(&state);
  if (status != ISAL_DECOMP_OK || state.avail_out != 0) return std::nullopt;
  return bytes;
}

}  // namespace inkbench
