// SPDX-License-Identifier: MIT
#include "studies/report/lettering.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

/// The font's file. Folders: of Debian and its kin, Fedora, Arch.
std::string font_file(Face face) {
  const std::string name = face == Face::bold ? "DejaVuSans-Bold.ttf" : "DejaVuSans.ttf";
  for (const char* folder : {"truetype/dejavu", "dejavu-sans-fonts", "TTF"}) {
    const std::filesystem::path path = std::filesystem::path("/usr/share/fonts") / folder / name;
    if (std::filesystem::exists(path)) return path.string();
  }
  throw work_error("", "the font " + name + " was not found", "install the package fonts-dejavu-core");
}

/// The bytes of the character that starts at `at`. A stray byte of broken UTF-8 counts as a character.
size_t character_bytes(std::string_view text, size_t at) {
  size_t end = at + 1;
  while (end < text.size() && (static_cast<uint8_t>(text[end]) & 0xc0) == 0x80) ++end;
  return end - at;
}

/// The Unicode number of one character; U+FFFD where its bytes are broken.
char32_t code_point(std::string_view character) {
  const auto first = static_cast<uint8_t>(character.front());
  if (first < 0x80 && character.size() == 1) return first == '\t' ? U' ' : first;
  const size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc0 ? 2 : 0;
  if (bytes == 0 || bytes != character.size()) return 0xfffd;
  char32_t code = first & (0x7f >> bytes);
  for (const char byte : character.substr(1)) code = code << 6 | (static_cast<uint8_t>(byte) & 0x3f);
  return code;
}

/// Calls `use(code)` for each character of `line`.
template <class Use>
void for_each_character(std::string_view line, Use&& use) {
  for (size_t at = 0, bytes = 0; at < line.size(); at += bytes) {
    bytes = character_bytes(line, at);
    use(code_point(line.substr(at, bytes)));
  }
}

/// Both faces, and how far the pen moves over characters met before. One thread at a time, by its mutex.
class Fonts {
 public:
  static Fonts& get() {
    static Fonts fonts;
    return fonts;
  }

  std::mutex& mutex() { return mutex_; }

  int advance_px(char32_t code, int size_px, Face face) {
    const auto [entry, is_new] = advances_.try_emplace({face, size_px, code}, 0);
    if (is_new) entry->second = pixels(glyph(code, size_px, face, FT_LOAD_DEFAULT));
    return entry->second;
  }

  bool has(char32_t code, Face face) const {
    return FT_Get_Char_Index(faces_[face == Face::bold ? 1 : 0].get(), code) != 0;
  }

  /// The drawn glyph, valid until the next call.
  const FT_GlyphSlotRec_* drawn(char32_t code, int size_px, Face face) {
    return glyph(code, size_px, face, FT_LOAD_RENDER);
  }

 private:
  using Library = std::unique_ptr<FT_LibraryRec_, decltype(&FT_Done_FreeType)>;
  using FaceHandle = std::unique_ptr<FT_FaceRec_, decltype(&FT_Done_Face)>;

  Fonts() : library_(open_library(), &FT_Done_FreeType) {
    for (const Face face : {Face::regular, Face::bold}) faces_.emplace_back(open_face(face), &FT_Done_Face);
  }

  static FT_Library open_library() {
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) throw work_error("", "FreeType cannot be started");
    return library;
  }

  FT_Face open_face(Face face) const {
    const std::string file = font_file(face);
    FT_Face handle = nullptr;
    if (FT_New_Face(library_.get(), file.c_str(), 0, &handle) != 0) {
      throw work_error(file, "is not a font that FreeType reads", "reinstall the package fonts-dejavu-core");
    }
    return handle;
  }

  static int pixels(const FT_GlyphSlotRec_* glyph) { return static_cast<int>((glyph->advance.x + 32) >> 6); }

  const FT_GlyphSlotRec_* glyph(char32_t code, int size_px, Face face, FT_Int32 flags) {
    FT_Face handle = faces_[face == Face::bold ? 1 : 0].get();
    FT_Set_Pixel_Sizes(handle, 0, static_cast<FT_UInt>(size_px));
    if (FT_Load_Char(handle, code, flags) != 0) {
      throw work_error("",
                       "the font cannot show the character " + std::to_string(static_cast<uint32_t>(code)));
    }
    return handle->glyph;
  }

  std::mutex mutex_;
  Library library_;
  std::vector<FaceHandle> faces_;
  std::map<std::tuple<Face, int, char32_t>, int> advances_;
};

/// As many as fit; of a path its last whole folder is the end.
std::string_view first_characters(std::string_view word, int width_px, int size_px, Face face) {
  size_t end = character_bytes(word, 0);  // At least one, or wrapping would not end.
  while (end < word.size()) {
    const size_t next = end + character_bytes(word, end);
    if (text_width_px(word.substr(0, next), size_px, face) > width_px) break;
    end = next;
  }
  const size_t slash = end < word.size() ? word.rfind('/', end - 1) : std::string_view::npos;
  return word.substr(0, slash == std::string_view::npos ? end : slash + 1);
}

void wrap_paragraph(const std::string& paragraph, int width_px, int size_px, Face face,
                    std::vector<std::string>& lines) {
  std::string line;
  for (const std::string& word : split(paragraph, ' ')) {
    if (word.empty()) continue;
    const std::string longer = line.empty() ? word : line + " " + word;
    if (text_width_px(longer, size_px, face) <= width_px) {
      line = longer;
      continue;
    }
    if (!line.empty()) lines.push_back(line);
    std::string_view rest = word;
    while (text_width_px(rest, size_px, face) > width_px && rest.size() > character_bytes(rest, 0)) {
      lines.emplace_back(first_characters(rest, width_px, size_px, face));
      rest.remove_prefix(lines.back().size());
    }
    line = rest;
  }
  lines.push_back(line);
}

bool fits(const std::string& text, int width_px, int max_lines, int size_px, Face face) {
  if (text_width_px(text, size_px, face) <= width_px && text.find('\n') == std::string::npos) return true;
  return widest_word_px(text, size_px, face) <= width_px &&
         std::ssize(wrapped(text, width_px, size_px, face)) <= max_lines;
}

/// Smaller by about a twentieth: finer steps cannot be seen, and each size must be measured.
int next_smaller(int size_px) {
  return size_px - std::max(1, size_px / 20);
}

/// The largest size within the limits with which all texts fit on `max_lines`, or 0.
int largest_fitting(std::span<const std::string> texts, const FitLimits& limits, int max_lines, Face face) {
  int size_px = limits.largest_px;
  for (const std::string& text : texts) {
    while (!fits(text, limits.width_px, max_lines, size_px, face)) {
      if (size_px <= limits.smallest_px) return 0;
      size_px = std::max(limits.smallest_px, next_smaller(size_px));
    }
  }
  return size_px;
}

void blend(Picture& picture, int x, int y, const std::array<uint8_t, 3>& colour, int ink) {
  if (x < 0 || y < 0 || x >= picture.width_px || y >= picture.height_px || ink == 0) return;
  for (int i = 0; i < 3; ++i) {
    uint8_t& sample = picture.at(x, y, i);
    sample = static_cast<uint8_t>((sample * (255 - ink) + colour[i] * ink + 127) / 255);
  }
}

/// Draws a glyph whose pen stands `pen_px` from the line's start (x, y).
void draw_glyph(Picture& picture, int x, int y, int pen_px, const FT_GlyphSlotRec_& glyph,
                const TextStyle& style, bool upwards) {
  const FT_Bitmap& bitmap = glyph.bitmap;
  for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
    for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
      const int along = pen_px + glyph.bitmap_left + column;
      const int below = row - glyph.bitmap_top;
      const int ink = bitmap.buffer[row * bitmap.pitch + column];
      blend(picture, upwards ? x + below : x + along, upwards ? y - along : y + below, style.colour, ink);
    }
  }
}

}  // namespace

int line_height_px(int size_px) {
  return (size_px * 5 + 3) / 4;
}

int baseline_px(int size_px) {
  return (size_px * 24 + 12) / 25;
}

int text_width_px(std::string_view line, int size_px, Face face) {
  Fonts& fonts = Fonts::get();
  const std::lock_guard lock(fonts.mutex());
  int width = 0;
  for_each_character(line, [&](char32_t code) { width += fonts.advance_px(code, size_px, face); });
  return width;
}

int widest_word_px(std::string_view text, int size_px, Face face) {
  int widest = 0;
  for (const std::string& line : split(text, '\n')) {
    for (const std::string& word : split(line, ' '))
      widest = std::max(widest, text_width_px(word, size_px, face));
  }
  return widest;
}

std::string with_boxes(std::string_view line) {
  Fonts& fonts = Fonts::get();
  const std::lock_guard lock(fonts.mutex());
  std::string result;
  for (size_t at = 0, bytes = 0; at < line.size(); at += bytes) {
    bytes = character_bytes(line, at);
    const std::string_view character = line.substr(at, bytes);
    result += fonts.has(code_point(character), Face::regular) ? character : "\u25a1";
  }
  return result;
}

std::vector<std::string> wrapped(std::string_view text, int width_px, int size_px, Face face) {
  std::vector<std::string> lines;
  for (const std::string& paragraph : split(text, '\n'))
    wrap_paragraph(paragraph, width_px, size_px, face, lines);
  if (lines.empty()) lines.emplace_back();
  return lines;
}

int fitted_size_px(std::span<const std::string> texts, const FitLimits& limits, Face face) {
  int best = 0;
  for (int lines = 1; lines <= limits.max_lines && best * 10 < limits.largest_px * 7; ++lines) {
    best = std::max(best, largest_fitting(texts, limits, lines, face));
  }
  return std::max(best, limits.smallest_px);
}

void draw_text(Picture& picture, int x, int y, std::string_view line, const TextStyle& style, bool upwards) {
  assert(picture.channels == 3);
  Fonts& fonts = Fonts::get();
  const std::lock_guard lock(fonts.mutex());
  int pen_px = 0;
  for_each_character(line, [&](char32_t code) {
    draw_glyph(picture, x, y, pen_px, *fonts.drawn(code, style.size_px, style.face), style, upwards);
    pen_px += fonts.advance_px(code, style.size_px, style.face);
  });
}

}  // namespace inkbench
