// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/package_mesh.h"

#include <unistd.h>

#include <array>
#include <string_view>
#include <system_error>
#include <vector>

#include "pipeline/base/cache_folder.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/key.h"
#include "pipeline/base/run_program.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

struct MeshPackage {
  std::string_view name;
  std::string_view folder;   ///< Of its files, or of those in its archive.
  std::string_view archive;  ///< A .tar.gz that holds them; "" where they lie in the folder.
};

constexpr std::array kPackages{
    MeshPackage{"libcgal-demo", "data/meshes", "/usr/share/doc/libcgal-dev/data.tar.gz"},
    MeshPackage{"glmark2-data", "/usr/share/glmark2/models", ""},
    MeshPackage{"assimp-testmodels", "/usr/share/assimp/models", ""},
    MeshPackage{"geomview", "/usr/share/geomview/geom", ""},
};

const MeshPackage& package_of(const std::string& name, std::string_view package) {
  std::vector<std::string> names;
  for (const MeshPackage& each : kPackages) {
    if (each.name == package) return each;
    names.emplace_back(each.name);
  }
  throw input_error("debian:" + name, "names no package whose meshes are known",
                    "they are " + join(names, ", ") + "; for example debian:libcgal-demo/fandisk.off");
}

[[noreturn]] void throw_not_installed(const std::string& name, const MeshPackage& package) {
  throw input_error("debian:" + name, "the package " + std::string(package.name) + " is not installed",
                    "apt-get install " + std::string(package.name));
}

/// The archive's folder in the cache, by the archive's size and time: another version is unpacked anew.
fs::path unpacked(const std::string& name, const MeshPackage& package) {
  std::error_code error;
  const auto size = fs::file_size(package.archive, error);
  if (error) throw_not_installed(name, package);
  const auto time = fs::last_write_time(package.archive, error).time_since_epoch().count();
  const Key key = KeyBuilder().add(std::to_string(size)).add(std::to_string(time)).key();
  // Without a cache in the folder for what is temporary, by user, since others may not be trusted there.
  const fs::path cache = cache_folder().empty()
                             ? fs::temp_directory_path() / ("inkbench-" + std::to_string(getuid()))
                             : cache_folder();
  const fs::path folder = cache / "packages" / (std::string(package.name) + "-" + key.text());
  if (fs::is_directory(folder / package.folder, error)) return folder / package.folder;
  // Under another name until all is there: processes may race, and the last one wins.
  const fs::path unfinished = folder.string() + "." + std::to_string(getpid());
  fs::remove_all(unfinished, error);
  make_folder(unfinished);
  const ProgramEnd end =
      run_program({"tar", "--extract", "--gzip", "--file", std::string(package.archive), "--directory",
                   unfinished.string(), "--no-same-owner", std::string(package.folder)},
                  std::chrono::minutes(5), "install the package tar");
  if (end.status == 0) fs::rename(unfinished, folder, error);
  const bool is_there = fs::is_directory(folder / package.folder);
  fs::remove_all(unfinished, error);
  if (!is_there)
    throw work_error(std::string(package.archive), "cannot be unpacked into " + folder.string(), end.output);
  return folder / package.folder;
}

}  // namespace

fs::path find_package_mesh(const std::string& name) {
  const size_t slash = name.find('/');
  const std::string file = slash == std::string::npos ? "" : name.substr(slash + 1);
  const MeshPackage& package = package_of(name, std::string_view(name).substr(0, slash));
  const bool leaves_folder = ("/" + file + "/").find("/../") != std::string::npos || file.starts_with('/');
  std::error_code error;
  const fs::path folder = package.archive.empty() ? fs::path(package.folder) : unpacked(name, package);
  if (!fs::is_directory(folder, error)) throw_not_installed(name, package);
  const fs::path path = folder / file;
  if (file.empty() || leaves_folder || !fs::is_regular_file(path, error)) {
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error))
      files.push_back(entry.path().lexically_relative(folder).string());
    const std::string near = suggest(file, files), where = "its meshes lie in " + folder.string();
    throw input_error("debian:" + name, "the package brings no such file",
                      near.empty() ? where : near + " (" + where + ")");
  }
  return path;
}

}  // namespace inkbench
