// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/hear_signals.h"
#include "app/scene_options.h"
#include "app/terminal.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/log.h"
#include "pipeline/base/text.h"
#include "pipeline/export.h"
#include "pipeline/gl/context.h"
#include "pipeline/passes/curves/curves.h"
#include "pipeline/vector_export.h"
#include "pipeline/vectors/pdf_file.h"

namespace inkbench {
namespace {

struct RenderOptions {
  SceneOptions scene;
  std::string buffers, format = "png", out;
  bool centre_lines = false, regions = false;
  std::optional<double> plot_width_mm;
};

constexpr double kPlotWidthMm = 200.0;

bool makes_vectors(const RenderOptions& options) {
  return options.format == "svg" || options.format == "pdf";
}

void check_vector_buffer(BufferName buffer, const RenderOptions& options) {
  const std::string name(name_of(buffer));
  if (!is_of_lines(buffer)) {
    throw input_error("--format " + options.format, "the buffer " + name + " is not made of lines",
                      options.format + " is for reference, curves and strokes; use png or exr");
  }
  if (buffer == BufferName::reference && (options.centre_lines || options.regions)) {
    throw input_error(options.centre_lines ? "--centre-lines" : "--regions", "is not for the buffer " + name,
                      "use it with curves or strokes");
  }
}

void check_format(const RenderOptions& options, const std::vector<BufferName>& buffers) {
  if (!makes_vectors(options) && (options.centre_lines || options.regions)) {
    throw input_error(options.centre_lines ? "--centre-lines" : "--regions",
                      "is not for --format " + options.format, "add --format svg or --format pdf");
  }
  if (options.centre_lines && options.regions)
    throw input_error("--regions", "cannot be drawn by a pen", "leave out --regions or --centre-lines");
  if (options.plot_width_mm && !options.centre_lines)
    throw input_error("--plot-width", "is the width of centre lines alone", "add --centre-lines");
  for (const BufferName buffer : buffers) {
    if (makes_vectors(options)) check_vector_buffer(buffer, options);
  }
}

/// `out/<buffer>.<format>`
fs::path path_in_folder(BufferName buffer, const RenderOptions& options) {
  return fs::path(options.out) / (std::string(name_of(buffer)) + "." + options.format);
}

void write_vectors(const std::string& svg, BufferName buffer, const RenderOptions& options) {
  const fs::path path = path_in_folder(buffer, options);
  write_file_atomically(path, options.format == "pdf" ? pdf_of(svg) : svg);
  print_out("{}\n", path.string());
}

void write_plot(const Frame& frame, BufferName buffer, const RenderOptions& options) {
  const Plot plot = plot_of(frame, buffer, options.plot_width_mm.value_or(kPlotWidthMm));
  write_vectors(plot.svg, buffer, options);
  print_out("{}: {} lines; lifted, the pen travels {:.0f} mm, {:.0f} mm before they were put in order\n",
            name_of(buffer), plot.lines, plot.travel.after, plot.travel.before);
}

bool shows_curves(const Settings& settings, const std::vector<BufferName>& buffers) {
  return settings.ink.from != InkFrom::filter ||
         std::any_of(buffers.begin(), buffers.end(), [](BufferName buffer) {
           return buffer == BufferName::curves || buffer == BufferName::strokes;
         });
}

void render(const RenderOptions& options) {
  const auto [settings, made_from] = chosen_scene(options.scene);
  const std::string names = !options.buffers.empty()
                                ? options.buffers
                                : std::string(name_of(made_from.value_or(BufferName::final)));
  const std::vector<BufferName> buffers = parse_buffers(split(names, ','), "--buffers");
  check_format(options, buffers);
  const HeadlessContext context;
  Pipeline pipeline;
  const Frame frame = pipeline.at(settings);
  make_folder(options.out);
  const std::string below = options.regions ? shading_regions(pipeline, settings) : "";
  for (const BufferName buffer : buffers) {
    if (options.centre_lines) {
      write_plot(frame, buffer, options);
    } else if (makes_vectors(options)) {
      write_vectors(vector_text(frame, buffer, below), buffer, options);
    } else {
      const fs::path path = path_in_folder(buffer, options);
      write_buffer(frame, buffer, path);
      print_out("{}\n", path.string());
    }
  }
  if (shows_curves(settings, buffers)) {
    for (const std::string& note : frame.value<CurvesPass>()->notes) log_note(note);
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
                   "png: pictures; exr: raw 32-bit float values; svg, pdf: reference, curves or strokes as "
                   "vectors (pdf by rsvg-convert)")
      ->check(CLI::IsMember({"png", "exr", "svg", "pdf"}));
  command->add_flag("--regions", options->regions,
                    "Of svg and pdf: the shading as flat areas below the lines");
  command->add_flag("--centre-lines", options->centre_lines,
                    "Of svg and pdf: one path a line, in an order in which a pen plotter travels little");
  command
      ->add_option("--plot-width", options->plot_width_mm,
                   "Of --centre-lines: the sheet's width in mm; 200 without it")
      ->check(CLI::Range(1.0, 10000.0));
  command->add_option("--out", options->out, "Folder for the images, made if missing")->required();
  command->footer(
      "Examples:\n  inkbench render --buffers all --out out/paper\n"
      "  inkbench render --mesh head.ply --size 1024x768 --set combine.k_normal=0.02 --out out/head\n"
      "  inkbench render --from out/paper/final.png --out out/again\n"
      "  inkbench render --buffers strokes --format svg --regions --out out/cartoon\n"
      "  inkbench render --buffers curves --format svg --centre-lines --plot-width 180 --out out/plot");
  command->callback([options] {
    hear_signals();
    render(*options);
  });
}

}  // namespace inkbench
