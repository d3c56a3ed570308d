// SPDX-License-Identifier: MIT
// What grid and page show of a study's pictures, kept in tiles/ from when each is drawn, on the thread that
// encodes it. A later run that finds a picture's tile need not decode the picture. In: pictures. Out: a file
// each, named by a hash of the picture's file, of its place in the grid and of the code that scales.
#pragma once

#include <atomic>
#include <filesystem>
#include <set>
#include <string>

#include "studies/sweep/kept_picture.h"
#include "studies/sweep/spec.h"
#include "studies/sweep/study_folder.h"
#include "studies/sweep/study_grid.h"

namespace inkbench {

class CellTiles {
 public:
  /// Errors (work): the grid's font is missing.
  CellTiles(const StudySpec& spec, std::filesystem::path folder);

  /// Keeps what is shown of a cell's picture; `hash` is its file's. Once a tile cannot be written, the disk
  /// being full, no more are kept: they are made when they are needed. Safe from any thread.
  void keep(size_t cell, size_t shown, const Picture& picture, const std::string& hash);

  /// Makes the tiles that are not there of all pictures of finished cells, on several threads.
  void keep_missing(const StudyFolder& folder);

  /// Of a finished cell's picture; decodes it where its tile is missing or damaged. Errors (input): the
  /// picture cannot be read.
  KeptPicture get(const StudyFolder& folder, size_t cell, size_t shown);

  /// Removes the tiles that `get` did not give.
  void remove_others() const;

  /// Reads a picture, and counts it.
  Picture decode(const std::filesystem::path& path);
  size_t decoded() const { return decoded_; }

 private:
  KeptPicture make(size_t cell, size_t shown, const Picture& picture) const;
  std::filesystem::path path_of(size_t cell, size_t shown, const std::string& hash) const;
  void write(const std::filesystem::path& path, const KeptPicture& kept);

  struct Thumbnails {
    ThumbnailPlan most, least;  ///< The page's plan lies between; it is known when all cells have ended.
  };
  /// Of one of a cell's pictures; both without a side where it has none.
  Thumbnails thumbnails_of(size_t cell, size_t shown) const;

  std::filesystem::path folder_;  ///< tiles/
  CellLayout layout_;
  Thumbnails thumbnails_;
  std::set<std::string> used_;
  std::atomic<size_t> decoded_ = 0;
  std::atomic<bool> can_write_ = true;
};

}  // namespace inkbench
