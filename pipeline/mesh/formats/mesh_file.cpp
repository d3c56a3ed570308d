// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/mesh_file.h"

#include <fmt/format.h>

#include <cstdlib>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/formats/isolated_call.h"
#include "pipeline/mesh/formats/mesh_reader.h"
#include "pipeline/mesh/formats/mesh_source.h"
#include "pipeline/mesh/formats/soup_transfer.h"
#include "pipeline/mesh/polygon_soup.h"

namespace inkbench {
namespace {

constexpr uintmax_t kMaxFileBytes = uintmax_t{2} << 30;
constexpr const char* kKnownFormats = "known formats are .obj, .ply, .off and .stl";

MeshFormat format_of(const fs::path& path) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".ply") return MeshFormat::ply;
  if (extension == ".off") return MeshFormat::off;
  if (extension == ".stl") return MeshFormat::stl;
  throw input_error(path.string(), "unknown mesh format '" + extension + "'", kKnownFormats);
}

std::string read_raw(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_directory(status)) {
    if (!fs::is_regular_file(status)) throw input_error(path.string(), "is not a regular file");
    const uintmax_t size = fs::file_size(path, error);
    if (error) throw input_error(path.string(), "cannot be opened: " + error.message());
    if (size == 0) throw input_error(path.string(), "is empty", "a mesh file is needed");
    if (size > kMaxFileBytes) {
      throw input_error(path.string(), "is larger than 2 GB: " + readable_bytes(static_cast<double>(size)),
                        "reduce the mesh first");
    }
  }
  return read_file(path);
}

/// Far from what good files take (30 MB a second, 2 bytes of memory for each of the file), so that only a
/// reader gone astray meets them.
IsolationLimits limits_for(const MeshSource& source) {
  const size_t megabytes = source.bytes.size() >> 20;
  return {std::chrono::seconds(10 + 2 * megabytes), (size_t{256} << 20) + 32 * source.bytes.size()};
}

PolygonSoup read_isolated(const MeshSource& source, const std::string& name) {
  const IsolatedResult result = call_isolated(
      [&](const ByteSink& sink) { send_soup(read_with_openmesh(source), sink); }, limits_for(source));
  switch (result.end) {
    case IsolatedEnd::returned:
      return receive_soup(result.bytes);
    case IsolatedEnd::threw:
      throw input_error(name, result.text());
    case IsolatedEnd::out_of_memory:
      throw input_error(name, "reading it needs more memory than its size can justify",
                        "is the file damaged?");
    case IsolatedEnd::crashed:
      throw input_error(name, "OpenMesh's reader crashed on it", "is the file damaged?");
    case IsolatedEnd::timed_out:
      break;
  }
  throw input_error(name, "OpenMesh's reader did not come to an end", "is the file damaged?");
}

/// The readers for OBJ and STL silently leave out faces naming a vertex twice; the others must return each
/// one.
void account_for_faces(const MeshSource& source, PolygonSoup& soup, const std::string& name) {
  const bool merges_corners = source.format == MeshFormat::stl;
  const bool leaves_out = merges_corners || source.format == MeshFormat::obj;
  const uint64_t read = soup.corner_counts.size();
  const bool all_vertices = merges_corners || soup.points.size() == source.vertices;
  if (!all_vertices || read > source.faces || (read < source.faces && !leaves_out)) {
    throw input_error(name, fmt::format("OpenMesh read {} vertices and {} faces where the file has {} and {}",
                                        soup.points.size(), read, source.vertices, source.faces));
  }
  soup.empty_polygons += source.faces - read + source.skipped_faces;
}

PolygonSoup read_soup(const fs::path& path) {
  const std::string name = path.string();
  const MeshFormat format = format_of(path);
  const MeshSource source = prepare_mesh(format, name, read_raw(path));
  PolygonSoup soup = read_isolated(source, name);
  account_for_faces(source, soup, name);
  soup.corners_are_rounded = format == MeshFormat::stl;
  return soup;
}

}  // namespace

Mesh load_mesh_file(const fs::path& path, const MeshOptions& options) {
  return mesh_from_soup(read_soup(path), path.string(), options);
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
