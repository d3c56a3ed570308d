#include "app/window/open_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "pipeline/base/error.h"
#include "pipeline/export.h"
#include "pipeline/mesh/mesh_file.h"
#include "pipeline/scene/replace_mesh.h"
#include "pipeline/scene/settings_file.h"

namespace inkbench {
namespace {

std::string extension_of(const std::filesystem::path& path) {
  std::string text = path.extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace

OpenedFile open_file(const Settings& current, const std::string& path) {
  const std::filesystem::path file(path);
  const std::string kind = extension_of(file);
  if (kind == ".toml") return {load_settings(file), file.filename().string(), true};
  if (kind == ".png" || kind == ".exr") return {read_origin(file).settings, file.filename().string(), true};
  if (kind == ".obj" || kind == ".ply" || kind == ".off" || kind == ".stl") {
    load_mesh_file(file);  // a mesh that cannot be read is told before anything changes
    OpenedFile opened{current, file.filename().string(), false};
    replace_main_mesh(opened.settings, file);
    return opened;
  }
  throw input_error(path, "is not a kind of file that can be opened",
                    "a scene (.toml), an exported image (.png, .exr) or a mesh (.obj, .ply, .off, .stl)");
}

}  // namespace inkbench
