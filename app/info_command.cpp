// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <functional>

#include "app/commands.h"
#include "app/workbench/recent_studies.h"
#include "app/workbench/user_folder.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/gl/context.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/levels/collapse_record_file.h"

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
  const fs::path cache = collapse_record_folder();
  fmt::print("data        {}\n", place(project_root));
  fmt::print("rabbit      {}\n", place(find_rabbit));
  fmt::print("presets     {}\n", place(user_folder));
  fmt::print("studies     {}\n", place(studies_folder));
  fmt::print("cache       {}\n", cache.empty() ? "none" : cache.string());
}

void print_info() {
  fmt::print("inkbench    {}\n", INKBENCH_VERSION);
  print_places();
  const HeadlessContext context;
  const RendererInfo info = renderer_info();
  fmt::print("renderer    {}\n", info.renderer);
  fmt::print("vendor      {}\n", info.vendor);
  fmt::print("OpenGL      {}\n", info.version);
  fmt::print("EGL         {} platform\n", context.platform());
  fmt::print("largest     {} x {} px\n", info.max_side_px, info.max_side_px);
}

}  // namespace

void add_info_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("info", "Show the renderer, versions and where files are looked for and kept");
  command->footer("Example:\n  inkbench info");
  command->callback(print_info);
}

}  // namespace inkbench
