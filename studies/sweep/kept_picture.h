// SPDX-License-Identifier: MIT
// What grid and report page show of one picture, as bytes: much smaller than the picture, and cheap to read.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/report/grid_tile.h"
#include "studies/report/thumbnail.h"

namespace inkbench {

struct KeptPicture {
  Tile tile;
  std::vector<Thumbnail> thumbnails;  ///< As `make_thumbnails` gives them; none where the page has no place.
  bool operator==(const KeptPicture&) const = default;
};

std::string bytes_of(const KeptPicture& kept);

/// Nothing where the bytes are not, to the last one, what `bytes_of` gave.
std::optional<KeptPicture> kept_picture(std::string_view bytes);

}  // namespace inkbench
