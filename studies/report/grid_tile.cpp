// SPDX-License-Identifier: MIT
#include "studies/report/grid_tile.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "studies/report/scaling.h"

namespace inkbench {
namespace {

/// Copies columns of `source`, as many as both have, to column `x` of `target`.
void copy_columns(const Picture& source, int first, int end, Picture& target, int x) {
  const int width = std::min({end, source.width_px, first + target.width_px - x}) - first;
  if (width <= 0) return;
  for (int y = 0; y < std::min(source.height_px, target.height_px); ++y)
    std::copy_n(&source.at(first, y), static_cast<size_t>(width) * 3, &target.at(x, y));
}

Picture columns(const Picture& source, int first, int end) {
  Picture result(end - first, source.height_px, 3);
  copy_columns(source, first, end, result, 0);
  return result;
}

Picture side_by_side(const Picture& a, const Picture& b) {
  if (a.width_px == 0) return b;
  if (b.width_px == 0) return a;
  Picture result(a.width_px + b.width_px, a.height_px, 3);
  copy_columns(a, 0, a.width_px, result, 0);
  copy_columns(b, 0, b.width_px, result, a.width_px);
  return result;
}

/// `picture` as it stands in its cell.
Picture in_place(const Picture& picture, const TilePlace& place) {
  Picture result(place.end_px - place.first_px, place.cell_height_px, 3, 255);
  copy_columns(picture, 0, picture.width_px, result, 0);
  return result;
}

/// The columns of the drawn cell that are means over the place's columns alone.
Samples own_columns(const TilePlace& place) {
  const auto covered = [&](int i) { return covered_samples(place.cell_width_px, place.drawn_width_px, i); };
  Samples own;
  while (own.first < place.drawn_width_px && covered(own.first).first < place.first_px) ++own.first;
  own.end = own.first;
  while (own.end < place.drawn_width_px && covered(own.end).end <= place.end_px) ++own.end;
  return own;
}

Scaling scaling_of(const TilePlace& place) {
  return {place.cell_width_px, place.drawn_width_px, place.drawn_height_px};
}

}  // namespace

Tile make_tile(const Picture& picture, const TilePlace& place) {
  assert(picture.channels == 3 && place.first_px < place.end_px);
  const int width = place.end_px - place.first_px;
  const bool fits = picture.width_px == width && picture.height_px == place.cell_height_px;
  const Picture moved = fits ? Picture() : in_place(picture, place);
  const Picture& whole = fits ? picture : moved;
  const auto covered = [&](int i) { return covered_samples(place.cell_width_px, place.drawn_width_px, i); };
  const Samples own = own_columns(place);
  if (own.first == own.end) return {place, own.first, {}, whole, {}};
  Tile tile{place, own.first, scaled_columns(whole, place.first_px, scaling_of(place), own), {}, {}};
  if (own.first > 0 && covered(own.first - 1).end > place.first_px)
    tile.left = columns(whole, 0, covered(own.first - 1).end - place.first_px);
  if (own.end < place.drawn_width_px && covered(own.end).first < place.end_px)
    tile.right = columns(whole, covered(own.end).first - place.first_px, width);
  return tile;
}

Picture joined(std::vector<Tile> tiles) {
  const TilePlace place = tiles.front().place;
  if (tiles.size() == 1 && tiles.front().drawn.width_px == place.drawn_width_px)
    return std::move(tiles.front().drawn);
  Picture cell(place.drawn_width_px, place.drawn_height_px, 3);
  Picture seam;  // columns of the cell as they are, from `seam_first` on
  int seam_first = 0, done = 0;
  const auto close_seam = [&](int end) {
    if (done >= end) return;
    const Picture part = scaled_columns(seam, seam_first, scaling_of(place), {done, end});
    copy_columns(part, 0, part.width_px, cell, done);
    done = end;
  };
  for (const Tile& tile : tiles) {
    if (seam.width_px == 0) seam_first = tile.place.first_px;
    seam = side_by_side(seam, tile.left);
    if (tile.drawn.width_px == 0) continue;
    close_seam(tile.drawn_first_px);
    copy_columns(tile.drawn, 0, tile.drawn.width_px, cell, done);
    done += tile.drawn.width_px;
    seam = tile.right;
    seam_first = tile.place.end_px - tile.right.width_px;
  }
  close_seam(place.drawn_width_px);
  return cell;
}

}  // namespace inkbench
