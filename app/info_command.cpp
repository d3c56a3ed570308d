// SPDX-License-Identifier: MIT
#include <functional>
#include <memory>

#include "app/commands.h"
#include "app/hear_signals.h"
#include "app/terminal.h"
#include "app/workbench/recent_studies.h"
#include "app/workbench/user_folder.h"
#include "pipeline/base/cache_folder.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/gl/context.h"
#include "pipeline/mesh/formats/mesh_file.h"

namespace inkbench {
namespace {

/// The place that `find` gives, or why there is none.
std::string place(const std::function<fs::path()>& find) {
  try {
    return find().string();
  } catch (const Error& error) {
    return std::string("not found: ") + error.what();
  }
}

void print_places() {
  const fs::path cache = cache_folder();
  print_out("data        {}\n", place(project_root));
  print_out("rabbit      {}\n", place(find_rabbit));
  print_out("presets     {}\n", place(user_folder));
  print_out("studies     {}\n", place(studies_folder));
  print_out("cache       {}\n", cache.empty() ? "none" : cache.string());
}

void print_info(bool only_meshes) {
  if (only_meshes) return print_out("{}\n", known_mesh_formats());
  print_out("inkbench    {}\n", INKBENCH_VERSION);
  print_places();
  const HeadlessContext context;
  const RendererInfo info = renderer_info();
  print_out("renderer    {}\n", info.renderer);
  print_out("vendor      {}\n", info.vendor);
  print_out("OpenGL      {}\n", info.version);
  print_out("EGL         {} platform\n", context.platform());
  print_out("largest     {} x {} px\n", info.max_side_px, info.max_side_px);
  print_out("meshes      {}\n", known_mesh_formats());
}

}  // namespace

void add_info_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("info", "Show the renderer, versions and where files are looked for and kept");
  auto only_meshes = std::make_shared<bool>(false);
  command->add_flag("--meshes", *only_meshes, "Only the endings of mesh files that can be read");
  command->footer("Example:\n  inkbench info");
  command->callback([only_meshes] {
    hear_signals();
    print_info(*only_meshes);
  });
}

}  // namespace inkbench
