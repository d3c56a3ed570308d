// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands.h"
#include "app/hear_signals.h"
#include "app/scene_options.h"
#include "app/terminal.h"
#include "pipeline/base/text.h"
#include "pipeline/gl/context.h"
#include "studies/judging/drawing_meter.h"

namespace inkbench {
namespace {

struct MeasureOptions {
  SceneOptions scene;
  std::string list;
  bool json = false, causes = false;
};

void print_list(const std::string& format) {
  if (format == "markdown") {
    print_out("{}", measures_markdown());
    return;
  }
  for (const Measure& measure : measure_table()) print_out("{:<18} {}\n", measure.key, measure.help);
}

void measure(const MeasureOptions& options) {
  if (!options.list.empty()) return print_list(options.list);
  const Settings settings = chosen_scene(options.scene).settings;
  const HeadlessContext context;
  Pipeline pipeline;
  const std::vector<const Measure*> measures = measures_of_a_view(options.causes);
  const DrawingTally tally = DrawingMeter(pipeline, MeasureNeeds::of(measures)).tally(pipeline.at(settings));
  if (options.json) {
    print_out("{}\n", measures_json(measures, tally));
    return;
  }
  print_out("The drawing against its reference lines, {} x {}, tolerance {} px\n", settings.image.width,
            settings.image.height, shortest(settings.judge.tolerance));
  if (tally.lines.empty())
    print_out("empty: neither has a line inside the border of {} px\n", kIgnoredBorderPx);
  print_out("{}", measures_table(measures, tally));
}

}  // namespace

void add_measure_command(CLI::App& app) {
  auto options = std::make_shared<MeasureOptions>();
  CLI::App* command =
      app.add_subcommand("measure", "Draw a scene and measure its lines against its reference lines");
  add_scene_options(*command, options->scene);
  command->add_flag("--json", options->json, "Print one JSON object and nothing else");
  command->add_flag("--causes", options->causes,
                    "Also count false and missed pixels by cause, which draws again a few times");
  command->add_option("--list", options->list, "Draw nothing; list the measures as text or markdown")
      ->check(CLI::IsMember({"text", "markdown"}));
  command->footer(
      "`--set judge.KEY=VALUE` judges in another way.\n"
      "Examples:\n  inkbench measure --set combine.k_normal=0.02 --size 1024x1024\n"
      "  inkbench measure --from out/paper/final.png --set judge.tolerance=1 --json");
  command->callback([options] {
    hear_signals();
    measure(*options);
  });
}

}  // namespace inkbench
