// SPDX-License-Identifier: MIT
// Small pictures that lie inside the report page. In: how many there will be and the room for them, then each
// picture. Out: base64 of a WebP file, which is half the size of a JPEG file here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/image/image.h"

namespace inkbench {

struct ThumbnailPlan {
  int side_px = 0;       ///< The longer side; 0: there is no room for any.
  size_t max_chars = 0;  ///< Of each one's text, so that all of them fit.
  size_t per_cell = 0;   ///< How many of a cell's pictures get one: all of them, or the first alone.
};

/// At most 240 px a side, 180 or 128 where there are more than 100 or 250, less where they would not fit into
/// `room_chars`; where they would be tiny, only the first picture of each cell gets one.
ThumbnailPlan plan_thumbnails(size_t cells, size_t pictures_per_cell, size_t room_chars);

/// One of the sizes that a picture may be shown at.
struct Thumbnail {
  int side_px = 0;
  std::string webp;
  bool operator==(const Thumbnail&) const = default;
};

/// Of a picture (3 channels), before the room for it is known: all that any plan between `most` and `least`
/// may choose, the largest first; mostly one.
std::vector<Thumbnail> make_thumbnails(const Picture& picture, const ThumbnailPlan& most,
                                       const ThumbnailPlan& least);

/// What `thumbnail` would give for the picture they were made of; nothing where that is not among them.
std::optional<std::string> chosen_thumbnail(const std::vector<Thumbnail>& made, const ThumbnailPlan& plan);

/// The picture (3 channels) at the plan's size, or smaller where it would take more than its share; never
/// larger than it is. "" where even the smallest does not fit. Thin lines stay visible: means are taken so
/// that dark lines on light ground and light lines on dark ground keep their contrast.
std::string thumbnail(const Picture& picture, const ThumbnailPlan& plan);

}  // namespace inkbench
