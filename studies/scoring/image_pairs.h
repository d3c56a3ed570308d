// SPDX-License-Identifier: MIT
// Which prediction belongs to which drawings. In: two images, or two folders whose files share names. Out:
// the pairs, by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace inkbench {

/// One image.
struct ImagePair {
  std::string name;  ///< The prediction's file without folder and ending.
  std::filesystem::path prediction;
  std::vector<std::filesystem::path> drawings;  ///< At least one.
};

struct ImagePairs {
  std::vector<ImagePair> pairs;    ///< In order of names.
  std::vector<std::string> notes;  ///< What was left out.
};

/// Two images are a pair whatever they are called. For a prediction and a folder, all images in the folder
/// are drawings of several annotators, unless one entry has the prediction's name. Of two folders, each
/// prediction goes with the image, the ground truth of BSDS500 (.mat) or the folder of annotators' images
/// that has its name. Hidden files and what is no image by its ending or its first bytes do not count. Errors
/// (input): a path that does not exist, a folder of predictions for one reference, a file without a partner
/// on either side, two files of one name, a folder without an image.
ImagePairs pair_images(const std::filesystem::path& predictions, const std::filesystem::path& references);

}  // namespace inkbench
