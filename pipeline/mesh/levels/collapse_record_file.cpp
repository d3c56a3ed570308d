// SPDX-License-Identifier: MIT
#include "pipeline/mesh/levels/collapse_record_file.h"

#include <array>
#include <cstdlib>
#include <cstring>
#include <type_traits>

#include "pipeline/base/cache_folder.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/log.h"
#include "pipeline/mesh/levels/decimation.h"

namespace inkbench {
namespace {

/// To be raised with every change of the file's layout or of what the decimation does: it is part of the key.
constexpr uint32_t kVersion = 1;
constexpr std::array<char, 8> kMagic{'I', 'N', 'K', 'D', 'E', 'C', 'I', 'M'};

struct Header {
  std::array<char, 8> magic = kMagic;
  uint32_t byte_order = 0x01020304;
  uint32_t version = kVersion;
  Key key;
  Key content;  ///< Of everything after the header.
  std::array<uint64_t, 5> sizes{};
};
static_assert(std::is_trivially_copyable_v<Header> && sizeof(Header) == 88);

/// The one list of what a file holds, in order. `Record` is const to write and not to read.
template <class Record, class Visit>
void for_each_array(Record& record, Visit&& visit) {
  visit(record.corners);
  visit(record.origin);
  visit(record.next_equal);
  visit(record.collapses);
  visit(record.faces);
}

template <class Item>
size_t bytes_of(const std::vector<Item>& items) {
  static_assert(std::is_trivially_copyable_v<Item> && sizeof(Item) % 4 == 0);
  return items.size() * sizeof(Item);
}

Key content_key(std::string_view content) {
  return KeyBuilder().add(content).key();
}

template <class Item>
void add_array(KeyBuilder& builder, const std::vector<Item>& items) {
  builder.add_bytes({reinterpret_cast<const uint8_t*>(items.data()), bytes_of(items)});
}

/// May this many items be read? In whole: the arrays fill the content exactly.
bool sizes_fit(const Header& header, size_t content_bytes) {
  CollapseRecord empty;
  size_t i = 0;
  size_t left = content_bytes;
  bool fit = true;
  for_each_array(empty, [&]<class Item>(const std::vector<Item>&) {
    const uint64_t size = header.sizes[i++];
    fit = fit && size <= left / sizeof(Item);
    if (fit) left -= size * sizeof(Item);
  });
  return fit && left == 0;
}

std::optional<CollapseRecord> read_from(const fs::path& path, const Mesh& mesh, const Key& key) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  try {
    return read_collapse_record(read_file(path), mesh, key);
  } catch (const Error&) {
    return std::nullopt;  // unreadable, or gone since: it is made anew
  }
}

}  // namespace

Key collapse_record_key(const Mesh& mesh) {
  KeyBuilder builder;
  builder.add("collapse record " + std::to_string(kVersion));
  add_array(builder, mesh.positions);
  add_array(builder, mesh.triangles);
  return builder.key();
}

std::string write_collapse_record(const CollapseRecord& record, const Key& key) {
  Header header;
  header.key = key;
  std::string content;
  size_t i = 0;
  for_each_array(record, [&]<class Item>(const std::vector<Item>& items) {
    header.sizes[i++] = items.size();
    content.append(reinterpret_cast<const char*>(items.data()), bytes_of(items));
  });
  header.content = content_key(content);
  return std::string(reinterpret_cast<const char*>(&header), sizeof header) + content;
}

std::optional<CollapseRecord> read_collapse_record(std::string_view bytes, const Mesh& mesh, const Key& key) {
  const Header expected;
  Header header;
  if (bytes.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, bytes.data(), sizeof header);
  bytes.remove_prefix(sizeof header);
  if (header.magic != expected.magic || header.byte_order != expected.byte_order ||
      header.version != expected.version || header.key != key || !sizes_fit(header, bytes.size()) ||
      header.content != content_key(bytes))
    return std::nullopt;
  CollapseRecord record;
  size_t i = 0;
  for_each_array(record, [&]<class Item>(std::vector<Item>& items) {
    items.resize(header.sizes[i++]);
    if (items.empty()) return;
    std::memcpy(items.data(), bytes.data(), bytes_of(items));
    bytes.remove_prefix(bytes_of(items));
  });
  if (!is_record_of(record, mesh)) return std::nullopt;
  return record;
}

fs::path collapse_record_path(const Key& key) {
  return cache_folder() / (key.text() + ".collapses");
}

CollapseRecord cached_collapse_record(const Mesh& mesh, const StopAsked& stop) {
  if (cache_folder().empty()) return record_collapses(mesh, stop);
  const Key key = collapse_record_key(mesh);
  const fs::path path = collapse_record_path(key);
  if (std::optional<CollapseRecord> found = read_from(path, mesh, key)) return std::move(*found);
  CollapseRecord record = record_collapses(mesh, stop);
  try {
    write_file_atomically(path, write_collapse_record(record, key));
  } catch (const Error& error) {
    log_note(std::string("the decimation is not kept for next time: ") + error.what());
  }
  return record;
}

}  // namespace inkbench
