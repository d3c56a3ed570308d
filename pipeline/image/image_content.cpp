// SPDX-License-Identifier: MIT
#include "pipeline/image/image_content.h"

#include <optional>
#include <utility>

#include "pipeline/image/png_chunks.h"

namespace inkbench {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kExrSignature = "\x76\x2f\x31\x01";
constexpr size_t kExrHeadBytes = 8;           // signature and version
constexpr uint32_t kExrMultiPart = 1U << 12;  // a bit of the version: more headers follow, then an empty one

/// Whether an end-of-image marker follows the last start-of-scan marker; neither occurs inside coded data.
bool jpeg_is_whole(std::string_view content) {
  const size_t scan = content.rfind("\xff\xda");
  return scan != std::string_view::npos && content.find("\xff\xd9", scan) != std::string_view::npos;
}

int32_t little_endian(std::string_view bytes) {
  uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<uint8_t>(bytes[i]);
  return static_cast<int32_t>(value);
}

/// Takes a text that ends with a zero byte.
std::optional<std::string_view> take_text(std::string_view& rest) {
  const size_t end = rest.find('\0');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view text = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return text;
}

/// Calls `use(name, value)` for each attribute of one header and takes it; false where it runs past the end.
/// Source: OpenEXR file layout, "Header".
template <class Use>
bool take_header(std::string_view& rest, Use&& use) {
  while (true) {
    const std::optional<std::string_view> name = take_text(rest);
    if (!name) return false;
    if (name->empty()) return true;
    if (!take_text(rest) || rest.size() < 4) return false;  // the type
    const int32_t size = little_endian(rest);
    rest.remove_prefix(4);
    if (size < 0 || static_cast<size_t>(size) > rest.size()) return false;
    use(*name, rest.substr(0, static_cast<size_t>(size)));
    rest.remove_prefix(static_cast<size_t>(size));
  }
}

/// The same for all headers.
template <class Use>
bool take_headers(std::string_view content, Use&& use) {
  if (content.size() < kExrHeadBytes) return false;
  const bool several = (static_cast<uint32_t>(little_endian(content.substr(4))) & kExrMultiPart) != 0;
  content.remove_prefix(kExrHeadBytes);
  if (!several) return take_header(content, use);
  while (!content.starts_with('\0')) {
    if (!take_header(content, use)) return false;
  }
  return true;
}

}  // namespace

std::string_view image_format(std::string_view content) {
  constexpr std::pair<std::string_view, std::string_view> kFormats[] = {{"\x89PNG\r\n\x1a\n", "png"},
                                                                        {"\xff\xd8\xff", "jpeg"},
                                                                        {kExrSignature, "openexr"},
                                                                        {"II*\0"sv, "tiff"},
                                                                        {"MM\0*"sv, "tiff"},
                                                                        {"P4", "pnm"},
                                                                        {"P5", "pnm"},
                                                                        {"P6", "pnm"}};
  for (const auto& [signature, name] : kFormats) {
    if (content.starts_with(signature)) return name;
  }
  return "";
}

bool is_cut_off(std::string_view content) {
  const std::string_view format = image_format(content);
  if (format == "png") return !png_is_whole(content);
  if (format == "jpeg") return !jpeg_is_whole(content);
  if (format == "openexr") return !take_headers(content, [](std::string_view, std::string_view) {});
  return false;
}

bool exr_size_is_sound(std::string_view content) {
  bool is_sound = true;
  take_headers(content, [&](std::string_view name, std::string_view value) {
    if (name != "dataWindow" || value.size() != 16) return;
    const int64_t width = int64_t{little_endian(value.substr(8))} - little_endian(value) + 1;
    const int64_t height = int64_t{little_endian(value.substr(12))} - little_endian(value.substr(4)) + 1;
    const bool sides_are = width > 0 && height > 0 && width <= kMaxSidePx && height <= kMaxSidePx;
    is_sound = is_sound && sides_are && width * height <= static_cast<int64_t>(kMaxSamples);
  });
  return is_sound;
}

bool can_hold(std::string_view format, uint64_t bytes, uint64_t pixels) {
  uint64_t most = 0;  // pixels in a byte
  if (format == "png" || format == "jpeg")
    most = 8 * 1032;  // one bit each, 1032 times packed: all that deflate can do
  if (format == "pnm") most = 8;
  return most == 0 || pixels / most <= bytes;
}

}  // namespace inkbench
