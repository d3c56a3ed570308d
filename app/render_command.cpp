// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/hear_signals.h"
#include "app/scene_options.h"
#include "app/terminal.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/text.h"
#include "pipeline/export.h"
#include "pipeline/gl/context.h"

namespace inkbench {
namespace {

struct RenderOptions {
  SceneOptions scene;
  std::string buffers, format = "png", out;
};

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
  const auto [settings, made_from] = chosen_scene(options.scene);
  const std::string names = !options.buffers.empty()
                                ? options.buffers
                                : std::string(name_of(made_from.value_or(BufferName::final)));
  const std::vector<BufferName> buffers = parse_buffers(split(names, ','), "--buffers");
  check_format(options.format, buffers);
  const HeadlessContext context;
  Pipeline pipeline;
  const Frame frame = pipeline.at(settings);
  make_folder(options.out);
  for (const BufferName buffer : buffers) {
    print_out("{}\n", write_to_folder(frame, buffer, options).string());
  }
}

}  // namespace

void add_render_command(CLI::App& app) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Draw a scene and write its buffers as image files");
  add_scene_options(*command, options->scene);
  command->add_option("--buffers", options->buffers,
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
  command->callback([options] {
    hear_signals();
    render(*options);
  });
}

}  // namespace inkbench
