// SPDX-License-Identifier: MIT
// A file of a study's folder as it was written: its name, size and hash, by which a change is found.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace inkbench {

struct FileRecord {
  std::string name;  ///< Relative to the study's folder.
  uint64_t bytes = 0;
  std::string hash;
};

/// The record of a file as it lies on the disk. Errors (input): it cannot be read.
FileRecord record_file(const std::filesystem::path& folder, const std::string& name);

/// What is wrong with the file now: "is missing", "was changed"; "" where it is as it was.
std::string file_problem(const std::filesystem::path& folder, const FileRecord& file);

/// Whether the files are all there, unchanged.
bool files_intact(const std::filesystem::path& folder, const std::vector<FileRecord>& files);

nlohmann::ordered_json json_of(const std::vector<FileRecord>& files);

/// Errors (json::exception): it is not what `json_of` gives.
std::vector<FileRecord> files_of(const nlohmann::json& json);

/// A count in JSON. Errors (json::exception): it is -1, 1.5, 1e300 or true, of each of which `get` would make
/// a number.
uint64_t count_of(const nlohmann::json& value);

}  // namespace inkbench
