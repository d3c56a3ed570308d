// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/mesh_file.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/formats/mesh_readers.h"
#include "pipeline/mesh/formats/scene_import.h"
#include "pipeline/mesh/mesh_from_soup.h"

namespace inkbench {
namespace {

using Reader = PolygonSoup (*)(const std::string& name, std::string_view raw);

struct OwnFormat {
  std::string_view extension;
  Reader read;
};

constexpr std::array<OwnFormat, 4> kOwnFormats{
    {{".obj", read_obj}, {".ply", read_ply}, {".off", read_off}, {".stl", read_stl}}};

std::vector<std::string> texts(std::span<const std::string_view> words) {
  return {words.begin(), words.end()};
}

/// Text that editors of Windows save so is full of zero bytes, which readers would take for a binary file.
void check_encoding(const std::string& name, std::string_view raw) {
  if (raw.starts_with("\xFF\xFE") || raw.starts_with("\xFE\xFF"))
    throw input_error(name, "is text in UTF-16", "save it as UTF-8");
}

}  // namespace

void check_mesh_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status) || fs::is_directory(status)) read_file(path);  // which says so
  if (!fs::is_regular_file(status)) throw input_error(path.string(), "is not a regular file");
  const uintmax_t size = fs::file_size(path, error);
  if (error) throw input_error(path.string(), "cannot be opened: " + error.message());
  if (size == 0) throw input_error(path.string(), "is empty", "a mesh file is needed");
  if (size > kMostMeshBytes) {
    throw input_error(path.string(), "is larger than 2 GB: " + readable_bytes(static_cast<double>(size)),
                      "reduce the mesh first");
  }
}

std::vector<std::string_view> mesh_endings() {
  std::vector<std::string_view> endings;
  for (const OwnFormat& format : kOwnFormats) endings.push_back(format.extension);
  endings.insert(endings.end(), imported_endings().begin(), imported_endings().end());
  return endings;
}

std::string known_mesh_formats() {
  const std::vector<std::string_view> endings = mesh_endings();
  return join(texts(endings), ", ");
}

bool is_mesh_name(const fs::path& path) {
  const std::vector<std::string_view> endings = mesh_endings();
  return std::ranges::find(endings, lower_case(path.extension().string())) != endings.end();
}

PolygonSoup read_mesh_soup(const fs::path& path, const std::string& part) {
  const std::string name = path.string();
  if (is_imported(path)) {
    const std::shared_ptr<const ImportedScene> scene = import_scene(path);
    return part.empty() ? joined_soup(*scene) : find_part(*scene, part, name).soup;
  }
  const std::string extension = lower_case(path.extension().string());
  const auto format = std::ranges::find(kOwnFormats, extension, &OwnFormat::extension);
  if (format == kOwnFormats.end()) {
    throw input_error(name, "unknown mesh format '" + extension + "'",
                      "known formats are " + known_mesh_formats());
  }
  if (!part.empty()) {
    throw input_error(name, "has no parts, so none is '" + part + "'",
                      "only files of these formats have parts: " + join(texts(imported_endings()), ", "));
  }
  check_mesh_file(path);
  const std::string raw = read_file(path, kMostMeshBytes);
  check_encoding(name, raw);
  return format->read(name, raw);
}

Mesh load_mesh_file(const fs::path& path, const MeshOptions& options, const std::string& part) {
  return mesh_from_soup(read_mesh_soup(path, part), path.string(), options);
}

fs::path find_rabbit() {
  std::error_code error;
  const char* const chosen = std::getenv("INKBENCH_RABBIT");
  if (chosen != nullptr && *chosen != '\0') {
    if (fs::is_regular_file(chosen, error)) return chosen;
    throw input_error("INKBENCH_RABBIT", "no such file: " + std::string(chosen),
                      "set it to the rabbit's mesh file or unset it");
  }
  for (const char* const folder : {"/usr/share/glmark2/models", "/usr/local/share/glmark2/models"}) {
    const fs::path rabbit = fs::path(folder) / "bunny.obj";
    if (fs::is_regular_file(rabbit, error)) return rabbit;
  }
  throw input_error("", "the rabbit (bunny.obj) is not installed",
                    "install the Debian package glmark2-data, or set INKBENCH_RABBIT to its file");
}

}  // namespace inkbench
