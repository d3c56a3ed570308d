// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/assimp/file_access.h"

#include <filesystem>
#include <string>

#include "pipeline/mesh/formats/uri_escapes.h"

namespace inkbench {
namespace {

bool is_file(const std::string& place) {
  std::error_code error;
  return std::filesystem::is_regular_file(place, error);
}

/// The file that a place means; "" where there is none.
std::string file_at(const char* place) {
  if (is_file(place)) return place;
  const std::string meant = without_escapes(place);
  return is_file(meant) ? meant : "";
}

}  // namespace

bool FileAccess::Exists(const char* place) const {
  return !file_at(place).empty();
}

Assimp::IOStream* FileAccess::Open(const char* place, const char* mode) {
  const std::string file = file_at(place);
  return file.empty() ? nullptr : DefaultIOSystem::Open(file.c_str(), mode);
}

}  // namespace inkbench
