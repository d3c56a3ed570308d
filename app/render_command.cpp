#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/size_option.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/export.h"
#include "pipeline/gl/context.h"
#include "pipeline/mesh/levels/replace_mesh.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

struct RenderOptions {
  std::string scene, from, mesh, size, buffers, format = "png", out;
  std::vector<std::string> assignments;
};

Settings base_settings(const RenderOptions& options, std::string& buffers) {
  if (options.from.empty()) {
    return load_settings(options.scene.empty() ? project_file("data/scenes/paper.toml")
                                               : fs::path(options.scene));
  }
  ImageOrigin origin = read_origin(options.from);
  if (buffers.empty()) buffers = name_of(origin.buffer);
  return std::move(origin.settings);
}

void check_format(const std::string& format, const std::vector<BufferName>& buffers) {
  if (format != "svg") return;
  for (const BufferName buffer : buffers) {
    if (buffer == BufferName::reference) continue;
    throw input_error("--format svg", "the buffer " + std::string(name_of(buffer)) + " is not made of lines",
                      "svg is for reference alone; use png or exr");
  }
}

/// Writes `out/<buffer>.<format>`; returns its path.
fs::path write_to_folder(const Frame& frame, BufferName buffer, const RenderOptions& options) {
  const fs::path path = fs::path(options.out) / (std::string(name_of(buffer)) + "." + options.format);
  write_buffer(frame, buffer, path);
  return path;
}

void render(const RenderOptions& options) {
  std::string names = options.buffers;
  Settings settings = base_settings(options, names);
  if (!options.mesh.empty()) replace_main_mesh(settings, options.mesh);
  if (!options.size.empty()) apply_size(settings, options.size);
  for (const std::string& assignment : options.assignments) apply_assignment(settings, assignment);
  check_settings(settings);
  const std::vector<BufferName> buffers =
      parse_buffers(split(names.empty() ? "final" : names, ','), "--buffers");
  check_format(options.format, buffers);
  const HeadlessContext context;
  Pipeline pipeline;
  const Frame frame = pipeline.at(settings);
  make_folder(options.out);
  for (const BufferName buffer : buffers) {
    fmt::print("{}\n", write_to_folder(frame, buffer, options).string());
  }
}

}  // namespace

void add_render_command(CLI::App& app) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Draw a scene and write its buffers as image files");
  auto* scene =
      command->add_option("--scene", options->scene, "Scene file (TOML); the paper's scene without it");
  command->add_option("--from", options->from, "Make an exported image again, from the parameters it carries")
      ->excludes(scene);
  command->add_option("--mesh", options->mesh,
                      "Mesh file (OBJ, PLY, OFF, STL) to put where the main model stands");
  command->add_option("--size", options->size, "Image size in px, as WIDTHxHEIGHT");
  command
      ->add_option("--set", options->assignments,
                   "KEY=VALUE: set a parameter (`inkbench params` lists them); repeatable")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option(
      "--buffers", options->buffers,
      "Comma-separated: " + buffer_list() + ", or all; final without it");
  command
      ->add_option("--format", options->format,
                   "png: pictures; exr: raw 32-bit float values; svg: reference as paths")
      ->check(CLI::IsMember({"png", "exr", "svg"}));
  command->add_option("--out", options->out, "Folder for the images, made if missing")->required();
  command->footer(
      "Examples:\n  inkbench render --buffers all --out out/paper\n"
      "  inkbench render --mesh head.ply --size 1024x768 --set combine.k_normal=0.02 --out out/head\n"
      "  inkbench render --from out/paper/final.png --out out/again");
  command->callback([options] { render(*options); });
}

}  // namespace inkbench
