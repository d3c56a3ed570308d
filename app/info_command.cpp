#include <fmt/format.h>

#include "app/commands.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/gl/context.h"
#include "pipeline/mesh/formats/mesh_file.h"

namespace inkbench {
namespace {

std::string rabbit_place() {
  try {
    return find_rabbit().string();
  } catch (const Error& error) {
    return std::string("not found: ") + error.what();
  }
}

void print_info() {
  fmt::print("inkbench    {}\n", INKBENCH_VERSION);
  fmt::print("data        {}\n", project_root().string());
  fmt::print("rabbit      {}\n", rabbit_place());
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
  CLI::App* command = app.add_subcommand("info", "Show the renderer, versions and where data was found");
  command->footer("Example:\n  inkbench info");
  command->callback(print_info);
}

}  // namespace inkbench
