// SPDX-License-Identifier: MIT
#include "studies/tuning/picture_marks.h"

#include "pipeline/lines/drawing.h"

namespace inkbench {
namespace {

void add_map(KeyBuilder& builder, const LineMap& map) {
  builder.add_bytes({reinterpret_cast<const uint8_t*>(map.words().data()), map.words().size_bytes()});
}

}  // namespace

const PictureMarks::Entry* PictureMarks::find(size_t picture) {
  const std::optional<MarkFile>& file = spec_.pictures[picture].marks;
  if (!file) return nullptr;
  std::optional<Entry>& entry = entries_[picture];
  if (entry) return &*entry;
  MarkMaps marks = file->marks;
  if (!file->keeps_drawing)
    marks.drawn =
        line_map_from(pipeline_.at(picture_settings(spec_, spec_.pictures[picture])).raw(BufferName::lines));
  const CountedMarks counted = counted_marks(marks);
  KeyBuilder key;
  add_map(key, counted.wanted);
  add_map(key, counted.unwanted);
  entry = Entry{std::move(marks), counted, key.key()};
  return &*entry;
}

}  // namespace inkbench
