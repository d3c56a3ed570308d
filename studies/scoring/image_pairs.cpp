// SPDX-License-Identifier: MIT
#include "studies/scoring/image_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/stop.h"
#include "pipeline/base/system_reason.h"
#include "pipeline/base/text.h"
#include "pipeline/image/image_content.h"

namespace inkbench {
namespace {

constexpr std::array<std::string_view, 10> kEndings{".png",  ".jpg", ".jpeg", ".exr", ".tif",
                                                    ".tiff", ".pgm", ".ppm",  ".pbm", ".pnm"};
constexpr std::string_view kGroundTruth = ".mat";
constexpr size_t kFirstBytes = 16;
constexpr size_t kNamed = 3;  ///< Files that a message names.

/// What a side's folder holds, by name.
struct Listing {
  std::map<std::string, fs::path> images, folders;
  std::vector<std::string> left_out;
};

bool has_ending(const fs::path& path, bool ground_truth_counts) {
  const std::string ending = lower_case(path.extension().string());
  if (ending == kGroundTruth) return ground_truth_counts;
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

bool begins_as_image(const fs::path& path) {
  try {
    return !image_format(read_file_part(path, 0, kFirstBytes)).empty();
  } catch (const Error&) {
    return false;  // it has not said that it is one, either
  }
}

/// The file's own name where its ending is no image's.
std::string name_of(const fs::path& image) {
  return has_ending(image, true) ? image.stem().string() : image.filename().string();
}

void add_image(const fs::path& path, std::map<std::string, fs::path>& images) {
  const auto [other, is_new] = images.emplace(name_of(path), path);
  if (is_new) return;
  const auto& [first, second] = std::minmax(other->second, path);
  throw input_error(second.string(), "has the name of " + first.filename().string(),
                    "one file is needed for each image");
}

Listing listed(const fs::path& folder, bool ground_truth_counts) {
  Listing listing;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    stop_if_asked();
    const fs::path& path = entry->path();
    const std::string name = path.filename().string();
    std::error_code ignored;
    if (name.starts_with('.')) continue;
    if (entry->is_directory(ignored)) {
      listing.folders.emplace(name, path);
    } else if (has_ending(path, ground_truth_counts) || begins_as_image(path)) {
      add_image(path, listing.images);
    } else {
      listing.left_out.push_back(name);
    }
  }
  if (error) throw input_error(folder.string(), "cannot be listed: " + error.message());
  std::sort(listing.left_out.begin(), listing.left_out.end());
  return listing;
}

/// "a.txt, b.txt, c.txt and 4 more".
std::string named(const std::vector<std::string>& names) {
  const std::span<const std::string> first(names.data(), std::min(names.size(), kNamed));
  const size_t more = names.size() - first.size();
  return join(first, ", ") + (more > 0 ? fmt::format(" and {} more", more) : "");
}

void note_left_out(const fs::path& folder, const Listing& listing, bool folders_count,
                   std::vector<std::string>& notes) {
  std::vector<std::string> names = listing.left_out;
  if (!folders_count) {
    for (const auto& [name, path] : listing.folders) names.push_back(name + "/");
  }
  if (!names.empty()) notes.push_back(folder.string() + ": left out, being no images: " + named(names));
}

std::vector<fs::path> images_of_annotators(const fs::path& folder, std::vector<std::string>& notes) {
  const Listing listing = listed(folder, false);
  note_left_out(folder, listing, false, notes);
  std::vector<fs::path> paths;
  for (const auto& [name, path] : listing.images) paths.push_back(path);
  if (paths.empty())
    throw input_error(folder.string(), "holds no image", "one image for each annotator is needed");
  return paths;
}

/// The drawings of that name in the references; none where there are none.
std::vector<fs::path> drawings_of(const std::string& name, const Listing& references,
                                  std::vector<std::string>& notes) {
  const auto image = references.images.find(name), folder = references.folders.find(name);
  const bool has_image = image != references.images.end(), has_folder = folder != references.folders.end();
  if (has_image && has_folder)
    throw input_error(folder->second.string(), "has the name of " + image->second.filename().string(),
                      "give one image, or a folder with one for each annotator");
  if (has_image) return {image->second};
  return has_folder ? images_of_annotators(folder->second, notes) : std::vector<fs::path>{};
}

[[noreturn]] void throw_partnerless(const std::vector<std::string>& files, const fs::path& other,
                                    const std::string& expected) {
  throw input_error(named(files),
                    (files.size() == 1 ? "has no partner in " : "have no partner in ") + other.string(),
                    expected);
}

ImagePairs pair_folders(const fs::path& predictions, const fs::path& references) {
  const Listing left = listed(predictions, false), right = listed(references, true);
  ImagePairs result;
  note_left_out(predictions, left, false, result.notes);
  note_left_out(references, right, true, result.notes);
  if (left.images.empty())
    throw input_error(predictions.string(), "holds no image", "strength maps are needed");
  std::vector<std::string> without;
  for (const auto& [name, path] : left.images) {
    std::vector<fs::path> drawings = drawings_of(name, right, result.notes);
    if (drawings.empty()) without.push_back(path.string());
    result.pairs.push_back({name, path, std::move(drawings)});
  }
  if (!without.empty())
    throw_partnerless(without, references, "it must hold an image, a folder or a .mat file of the same name");
  for (const auto* side : {&right.images, &right.folders}) {
    for (const auto& [name, path] : *side) {
      if (!left.images.contains(name)) without.push_back(path.string());
    }
  }
  if (!without.empty())
    throw_partnerless(without, predictions,
                      "every reference needs a prediction; to score a part, take the others away");
  return result;
}

ImagePairs pair_one(const fs::path& prediction, const fs::path& references) {
  ImagePairs result;
  ImagePair pair{name_of(prediction), prediction, {references}};
  if (fs::is_directory(references)) {
    pair.drawings = drawings_of(pair.name, listed(references, true), result.notes);
    if (pair.drawings.empty()) pair.drawings = images_of_annotators(references, result.notes);
  }
  result.pairs.push_back(std::move(pair));
  return result;
}

}  // namespace

ImagePairs pair_images(const fs::path& predictions, const fs::path& references) {
  for (const fs::path& path : {predictions, references}) {
    std::error_code error;
    if (!fs::exists(path, error))
      throw input_error(path.string(), error ? error.message() : "does not exist");
  }
  if (!fs::is_directory(predictions)) return pair_one(predictions, references);
  if (!fs::is_directory(references))
    throw input_error(references.string(), "is one file, but " + predictions.string() + " is a folder",
                      "give a folder whose files have the predictions' names");
  return pair_folders(predictions, references);
}

}  // namespace inkbench
