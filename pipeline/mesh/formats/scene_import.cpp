// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/scene_import.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <mutex>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/formats/gltf_buffers.h"
#include "pipeline/mesh/formats/isolated_call.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/formats/scene_box.h"
#include "pipeline/mesh/formats/scene_importer.h"
#include "pipeline/mesh/formats/scene_transfer.h"

namespace inkbench {
namespace {

/// What Assimp reads well, of files that stand alone but for a glTF file's buffers: a change of a file that
/// another one draws in would go unseen.
constexpr std::array<std::string_view, 28> kImportedEndings{
    ".gltf",  ".glb",  ".fbx", ".dae", ".3ds", ".3mf", ".ac",  ".amf", ".ase", ".b3d",
    ".blend", ".cob",  ".dxf", ".ifc", ".iqm", ".lwo", ".lxo", ".md2", ".md3", ".md5mesh",
    ".ms3d",  ".ogex", ".smd", ".x",   ".x3d", ".xgl", ".zae", ".zgl"};

constexpr size_t kMostGltfText = size_t{256} << 20;

/// What tells a changed file.
struct FileStamp {
  fs::path path;
  uintmax_t bytes = 0;
  fs::file_time_type time;

  bool operator==(const FileStamp&) const = default;
};

FileStamp stamp_of(const fs::path& path) {
  std::error_code error;
  const uintmax_t bytes = fs::file_size(path, error);
  return {path, error ? 0 : bytes, fs::last_write_time(path, error)};
}

std::vector<FileStamp> stamps_of(const fs::path& path) {
  std::vector<FileStamp> stamps;
  for (const fs::path& file : files_read_with(path)) stamps.push_back(stamp_of(file));
  return stamps;
}

/// Far from what good files take, so that only a reader gone astray meets them.
IsolationLimits limits_for(const std::vector<FileStamp>& stamps) {
  uintmax_t bytes = 0;
  for (const FileStamp& stamp : stamps) bytes += stamp.bytes;
  return {std::chrono::seconds(20 + 4 * (bytes >> 20)), (size_t{512} << 20) + 100 * bytes};
}

ImportedScene read_isolated(const std::string& name, const IsolationLimits& limits) {
  const SceneImporter& importer = scene_importer();
  const IsolatedResult result = call_isolated(
      [&](const ByteSink& sink) {
        ImportedScene scene;
        std::string problem;
        if (!importer.read(name, scene, problem)) throw std::runtime_error(problem);
        send_scene(scene, sink);
      },
      limits);
  switch (result.end) {
    case IsolatedEnd::returned:
      return receive_scene(result.bytes);
    case IsolatedEnd::threw:
      throw input_error(name, "cannot be read" + (result.text().empty() ? "" : ": " + result.text()),
                        "is the file damaged?");
    case IsolatedEnd::out_of_memory:
      throw input_error(name, "reading it needs more memory than its size can justify",
                        "is the file damaged?");
    case IsolatedEnd::crashed:
      throw input_error(name, "Assimp's reader crashed on it", "is the file damaged?");
    case IsolatedEnd::timed_out:
      break;
  }
  throw input_error(name, "Assimp's reader did not come to an end", "is the file damaged?");
}

void check_buffers(const std::vector<FileStamp>& stamps) {
  for (size_t i = 1; i < stamps.size(); ++i) {
    std::error_code error;
    if (!fs::is_regular_file(stamps[i].path, error)) {
      throw input_error(stamps[0].path.string(), "its buffer is missing: " + stamps[i].path.string(),
                        "put the file beside it");
    }
  }
}

/// The last file that was read, and what it was then.
struct KeptScene {
  std::mutex mutex;
  std::vector<FileStamp> stamps;  ///< The file's first, then those of its buffers.
  std::shared_ptr<const ImportedScene> scene;

  bool is_of(const fs::path& path) const {
    if (scene == nullptr || stamps.front().path != path) return false;
    return std::ranges::all_of(stamps, [](const FileStamp& stamp) { return stamp_of(stamp.path) == stamp; });
  }
};

KeptScene& kept_scene() {
  static KeptScene kept;
  return kept;
}

void append_part(const PolygonSoup& part, bool has_normals, PolygonSoup& all) {
  const auto first_point = static_cast<int64_t>(all.points.size());
  const auto first_normal = static_cast<int64_t>(all.normals.size());
  // What names nothing in its part must not name a point of another.
  const auto moved = [](int32_t index, int64_t first, size_t count) {
    const bool is_good = index >= 0 && static_cast<size_t>(index) < count;
    return is_good && first + index <= INT32_MAX ? static_cast<int32_t>(first + index) : -1;
  };
  all.points.insert(all.points.end(), part.points.begin(), part.points.end());
  all.normals.insert(all.normals.end(), part.normals.begin(), part.normals.end());
  all.corner_counts.insert(all.corner_counts.end(), part.corner_counts.begin(), part.corner_counts.end());
  for (const int32_t corner : part.corners)
    all.corners.push_back(moved(corner, first_point, part.points.size()));
  for (const int32_t normal : part.corner_normals)
    all.corner_normals.push_back(moved(normal, first_normal, part.normals.size()));
  if (has_normals) all.corner_normals.resize(all.corners.size(), -1);
  all.is_flat = all.is_flat || part.is_flat;
  all.empty_polygons += part.empty_polygons;
}

}  // namespace

std::span<const std::string_view> imported_endings() {
  return kImportedEndings;
}

bool is_imported(const fs::path& path) {
  const std::string ending = lower_case(path.extension().string());
  return std::ranges::find(kImportedEndings, ending) != kImportedEndings.end();
}

std::vector<fs::path> files_read_with(const fs::path& path) {
  std::vector<fs::path> files{path};
  std::error_code error;
  const bool is_gltf = lower_case(path.extension().string()) == ".gltf";
  if (!is_gltf || !fs::is_regular_file(path, error) || fs::file_size(path, error) > kMostGltfText)
    return files;
  for (const fs::path& buffer : gltf_buffers(read_file(path, kMostGltfText)))
    files.push_back(path.parent_path() / buffer);
  return files;
}

std::shared_ptr<const ImportedScene> import_scene(const fs::path& path) {
  check_mesh_file(path);
  KeptScene& kept = kept_scene();
  const std::lock_guard lock(kept.mutex);
  if (kept.is_of(path)) return kept.scene;
  const std::vector<FileStamp> stamps = stamps_of(path);
  check_buffers(stamps);
  auto scene = std::make_shared<ImportedScene>(read_isolated(path.string(), limits_for(stamps)));
  if (scene->parts.empty()) {
    throw input_error(path.string(), "holds no faces", "a mesh needs triangles or polygons");
  }
  bring_into_reach(*scene);
  kept.stamps = stamps;
  kept.scene = scene;
  return scene;
}

PolygonSoup joined_soup(const ImportedScene& scene) {
  PolygonSoup all;
  const bool has_normals = std::ranges::any_of(
      scene.parts, [](const ImportedPart& part) { return !part.soup.corner_normals.empty(); });
  for (const ImportedPart& part : scene.parts) append_part(part.soup, has_normals, all);
  all.notes = scene.notes;
  return all;
}

const ImportedPart& find_part(const ImportedScene& scene, const std::string& part, const std::string& where) {
  std::vector<std::string> names;
  for (const ImportedPart& candidate : scene.parts) {
    if (candidate.name == part) return candidate;
    names.push_back(candidate.name);
  }
  size_t number = 0;
  const auto [end, status] = std::from_chars(part.data(), part.data() + part.size(), number);
  const bool is_number = status == std::errc() && end == part.data() + part.size();
  if (is_number && number >= 1 && number <= names.size()) return scene.parts[number - 1];
  throw input_error(where, "has no part '" + part + "' among its " + std::to_string(names.size()),
                    suggest(part, names));
}

}  // namespace inkbench
