// SPDX-License-Identifier: MIT
// STL, ASCII and binary. Keeps the corners; stored facet normals go, since they repeat the corners' order.
#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "pipeline/base/text.h"
#include "pipeline/mesh/formats/mesh_source.h"
#include "pipeline/mesh/formats/mesh_text.h"

namespace inkbench {
namespace {

constexpr size_t kHeaderBytes = 84;
constexpr size_t kFacetBytes = 50;

uint64_t announced_facets(std::string_view raw) {
  uint32_t count = 0;
  if (raw.size() >= kHeaderBytes) std::memcpy(&count, raw.data() + kHeaderBytes - 4, 4);
  return count;
}

/// OpenMesh merges corners through an ordered map, in which NaN compares equal to everything.
void replace_not_finite(std::string& bytes) {
  for (size_t facet = kHeaderBytes; facet + kFacetBytes <= bytes.size(); facet += kFacetBytes) {
    for (size_t i = 3; i < 12; ++i) {
      char* place = bytes.data() + facet + 4 * i;
      float value = 0.0F;
      std::memcpy(&value, place, 4);
      if (!std::isfinite(value)) std::memcpy(place, &kNotFinite, 4);
    }
  }
}

MeshSource prepare_binary(std::string_view raw) {
  MeshSource source;
  source.format = MeshFormat::stl;
  source.binary = true;
  source.bytes = raw;
  source.faces = announced_facets(raw);
  source.vertices = 3 * source.faces;
  replace_not_finite(source.bytes);
  return source;
}

class AsciiPreparation {
 public:
  AsciiPreparation(const std::string& name, std::string_view raw) : cursor_(name, raw) {
    source_.format = MeshFormat::stl;
    source_.bytes.reserve(raw.size());
  }

  MeshSource run() {
    while (cursor_.next_line()) {
      const std::string_view keyword = cursor_.token();
      if (is(keyword, "outer")) take_facet();
      if (is(keyword, "solid")) ended_ = false;
      if (is(keyword, "endsolid")) ended_ = true;
    }
    if (!ended_) {
      throw input_error(cursor_.name(),
                        fmt::format("truncated: no 'endsolid' after {} facets",
                                    with_commas(static_cast<long long>(source_.faces))),
                        "copy or download the file again");
    }
    return std::move(source_);
  }

 private:
  static bool is(std::string_view token, std::string_view word) {
    return token.size() == word.size() && starts_with_word(token, word);
  }

  void take_facet() {
    source_.bytes += "outer loop\n";
    for (int corner = 0; corner < 3; ++corner) {
      if (!cursor_.next_line() || !is(cursor_.token(), "vertex")) {
        throw cursor_.error(fmt::format("a facet has {} of its 3 'vertex' lines", corner),
                            "the file may be truncated or damaged here");
      }
      source_.bytes += "vertex ";
      append_three_numbers(cursor_, "a vertex", source_.bytes);
      ++source_.vertices;
    }
    ++source_.faces;
  }

  TextCursor cursor_;
  MeshSource source_;
  bool ended_ = false;
};

}  // namespace

MeshSource prepare_stl(const std::string& name, std::string_view raw) {
  // Size first: many binary files begin with "solid" too.
  const uint64_t announced = announced_facets(raw);
  if (raw.size() >= kHeaderBytes && raw.size() == kHeaderBytes + kFacetBytes * announced)
    return prepare_binary(raw);
  const bool is_text = raw.find('\0') == std::string_view::npos;
  if (is_text && starts_with_word(trim(raw), "solid")) return AsciiPreparation(name, raw).run();
  if (is_text || raw.size() < kHeaderBytes) {
    throw input_error(name, "is neither ASCII nor binary STL",
                      "ASCII begins with 'solid'; binary has 84 bytes and 50 for each facet");
  }
  const uint64_t held = (raw.size() - kHeaderBytes) / kFacetBytes;
  if (held < announced) throw truncation_error(name, 3 * announced, announced, 3 * held, held);
  throw input_error(name,
                    fmt::format("{} bytes do not fit the {} facets that the header announces",
                                with_commas(static_cast<long long>(raw.size())),
                                with_commas(static_cast<long long>(announced))),
                    "a binary STL has 84 bytes and 50 for each facet");
}

}  // namespace inkbench
