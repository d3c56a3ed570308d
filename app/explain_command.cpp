// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/hear_signals.h"
#include "app/scene_options.h"
#include "app/terminal.h"
#include "pipeline/base/error.h"
#include "pipeline/base/text.h"
#include "pipeline/explain.h"
#include "pipeline/gl/context.h"
#include "studies/judging/cause_finder.h"

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

constexpr const char* kNeither = "Neither false nor missed, nor is a pixel within the tolerance.";

std::string cause_line(const PixelCause& cause, int x, int y) {
  const std::string text = cause_text(cause);
  return cause.x == x && cause.y == y ? text
                                      : fmt::format("Pixel {}, {} beside it: {}", cause.x, cause.y, text);
}

/// One more field of the JSON object: null where nothing is false or missed.
std::string with_cause(const std::string& explanation, const std::optional<PixelCause>& cause) {
  auto json = nlohmann::ordered_json::parse(explanation);
  json["judged"] = nullptr;
  if (cause) {
    const CauseInfo& info = info_of(cause->cause);
    json["judged"] = {{"is", info.is_of_missed() ? "missed" : "false"},
                      {"cause", info.name},
                      {"measure", info.key},
                      {"pixel", {cause->x, cause->y}},
                      {"help", info.help},
                      {"remedy", info.remedy},
                      {"missing_factor", nullptr}};
    if (cause->missing_factor > 0) json["judged"]["missing_factor"] = cause->missing_factor;
  }
  return json.dump() + "\n";
}

/// An image that is too large to be drawn at twice its size is explained without a cause, and says so.
std::optional<PixelCause> cause_if_found(Pipeline& pipeline, const Settings& settings, int x, int y) {
  try {
    return find_cause(pipeline, settings, x, y);
  } catch (const Error& error) {
    print_error("inkbench: note: {}\n", error.what());
    return std::nullopt;
  }
}

void explain(const ExplainOptions& options) {
  const auto [x, y] = pixel_of(options.pixel);
  const Settings settings = chosen_scene(options.scene).settings;
  const HeadlessContext context;
  Pipeline pipeline;
  const Explanation explanation = explain_pixel(pipeline.at(settings), x, y);
  const std::optional<PixelCause> cause = cause_if_found(pipeline, settings, x, y);
  if (options.json) {
    print_out("{}", with_cause(explanation_json(explanation), cause));
  } else {
    print_out("{}{}\n", explanation_text(explanation), cause ? cause_line(*cause, x, y) : kNeither);
  }
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
