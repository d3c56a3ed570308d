// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>
#include <memory>

#include "app/commands.h"
#include "app/hear_signals.h"
#include "app/scene_options.h"
#include "app/terminal.h"
#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/explain.h"
#include "pipeline/gl/context.h"

namespace inkbench {
namespace {

struct ExplainOptions {
  SceneOptions scene;
  std::string pixel;
  bool json = false;
};

/// "X,Y". Errors (input): anything else.
std::array<int, 2> pixel_of(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  std::array<int, 2> pixel{};
  bool good = parts.size() == 2;
  for (size_t i = 0; good && i < 2; ++i) {
    const std::string_view part = trim(parts[i]);
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), pixel[i]);
    good = error == std::errc() && end == part.data() + part.size();
  }
  if (!good) throw input_error("--pixel " + text, "is no pixel", "give X,Y; 0,0 is the top left one");
  return pixel;
}

void explain(const ExplainOptions& options) {
  const auto [x, y] = pixel_of(options.pixel);
  const Settings settings = chosen_scene(options.scene).settings;
  const HeadlessContext context;
  Pipeline pipeline;
  const Explanation explanation = explain_pixel(pipeline.at(settings), x, y);
  print_out("{}", options.json ? explanation_json(explanation) : explanation_text(explanation));
}

}  // namespace

void add_explain_command(CLI::App& app) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = app.add_subcommand("explain", "Draw a scene and say why a pixel is a line or not");
  command->add_option("--pixel", options->pixel, "X,Y; 0,0 is the top left one")->required();
  add_scene_options(*command, options->scene);
  command->add_flag("--json", options->json, "Print one JSON object and nothing else");
  command->footer(
      "Examples:\n  inkbench explain --pixel 200,310\n"
      "  inkbench explain --pixel 200,310 --from out/paper/final.png --set combine.k_normal=0.02 --json");
  command->callback([options] {
    hear_signals();
    explain(*options);
  });
}

}  // namespace inkbench
