// SPDX-License-Identifier: MIT
#include "studies/sweep/cell_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/key.h"
#include "pipeline/base/stop.h"
#include "pipeline/base/text.h"
#include "pipeline/base/worker_pool.h"
#include "pipeline/image/image_file.h"
#include "studies/report/page.h"
#include "studies/sweep/number_columns.h"
#include "studies/sweep/result_origin.h"

namespace inkbench {
namespace {

constexpr std::string_view kEnding = ".tile";

/// Characters that the page may take besides thumbnails: its look and scripts, charts, names and numbers.
size_t most_page_chars(const StudySpec& spec, size_t cells) {
  const size_t chars = 300'000 + 200'000 * spec.charts.size() +
                       cells * (400 + 100 * picture_count(spec) + 24 * number_columns(spec).size());
  return std::min(chars, kMaxPageChars / 2);
}

/// The tile that the file holds; nothing where there is none, or not a whole one.
std::optional<KeptPicture> read_tile(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  try {
    return kept_picture(read_file(path));
  } catch (const Error&) {
    return std::nullopt;
  }
}

bool is_tile_name(const std::string& name) {
  const auto stem = without_ending(name, kEnding);
  return stem && is_hex(*stem, 32);
}

}  // namespace

CellTiles::CellTiles(const StudySpec& spec, fs::path folder)
    : folder_(std::move(folder)), layout_(cell_layout(spec)) {
  const size_t cells = std::min(cell_count(spec), kMaxPageCells);
  const size_t room = kMaxPageChars - most_page_chars(spec, cells);
  thumbnails_ = {plan_thumbnails(cells, picture_count(spec), kMaxPageChars),
                 plan_thumbnails(cells, picture_count(spec), room)};
}

CellTiles::Thumbnails CellTiles::thumbnails_of(size_t cell, size_t shown) const {
  if (cell >= kMaxPageCells || shown >= thumbnails_.most.per_cell) return {};
  // A plan for the first pictures alone says nothing of the others.
  if (shown >= thumbnails_.least.per_cell) return {thumbnails_.most, thumbnails_.most};
  return thumbnails_;
}

KeptPicture CellTiles::make(size_t cell, size_t shown, const Picture& picture) const {
  const auto [most, least] = thumbnails_of(cell, shown);
  return {make_tile(picture, place_of(layout_, shown, picture)), make_thumbnails(picture, most, least)};
}

fs::path CellTiles::path_of(size_t cell, size_t shown, const std::string& hash) const {
  const auto [most, least] = thumbnails_of(cell, shown);
  KeyBuilder builder;
  builder.add(kTileSources).add(hash).add(text_of(layout_, shown));
  builder.add(fmt::format("{} {} {}", most.side_px, least.side_px, least.max_chars));
  return folder_ / (builder.key().text() + std::string(kEnding));
}

void CellTiles::write(const fs::path& path, const KeptPicture& kept) {
  if (!can_write_) return;
  try {
    write_file_atomically(path, bytes_of(kept), Sync::later);
  } catch (const Error&) {
    can_write_ = false;  // the picture itself is there, and can be decoded
  }
}

void CellTiles::keep(size_t cell, size_t shown, const Picture& picture, const std::string& hash) {
  if (can_write_) write(path_of(cell, shown, hash), make(cell, shown, picture));
}

void CellTiles::keep_missing(const StudyFolder& folder) {
  const size_t threads = std::clamp<size_t>(std::thread::hardware_concurrency(), 1, 8);
  WorkerPool workers(threads, threads);
  std::error_code error;
  for (const size_t cell : folder.done_cells()) {
    stop_if_asked();
    const std::vector<FileRecord> pictures = folder.pictures(cell);
    for (size_t shown = 0; shown < pictures.size(); ++shown) {
      const FileRecord& file = pictures[shown];
      if (!can_write_ || fs::exists(path_of(cell, shown, file.hash), error)) continue;
      workers.add([this, cell, shown, hash = file.hash, path = folder.path() / file.name] {
        try {
          keep(cell, shown, decode(path), hash);
        } catch (const Error&) {
          // `get` says what is wrong with the picture.
        }
      });
    }
  }
  workers.wait();
}

KeptPicture CellTiles::get(const StudyFolder& folder, size_t cell, size_t shown) {
  const FileRecord file = folder.pictures(cell)[shown];
  const fs::path path = path_of(cell, shown, file.hash);
  used_.insert(path.filename().string());
  if (std::optional<KeptPicture> kept = read_tile(path)) return std::move(*kept);
  KeptPicture made = make(cell, shown, decode(folder.path() / file.name));
  write(path, made);
  return made;
}

Picture CellTiles::decode(const fs::path& path) {
  ++decoded_;
  return read_picture(path, 3);
}

void CellTiles::remove_others() const {
  remove_abandoned_files(folder_);
  std::vector<fs::path> others;
  std::error_code error;
  for (fs::directory_iterator entry(folder_, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (is_tile_name(name) && !used_.contains(name)) others.push_back(entry->path());
  }
  for (const fs::path& path : others) fs::remove(path, error);
}

}  // namespace inkbench
