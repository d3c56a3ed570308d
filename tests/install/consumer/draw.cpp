// SPDX-License-Identifier: MIT
// A program outside the tree that draws: prints width, height and channels of a bundled scene's raw final
// image.
#include <cstdio>

#include "pipeline/base/files.h"
#include "pipeline/gl/context.h"
#include "pipeline/pipeline.h"
#include "pipeline/settings/settings_file.h"

int main() {
  const inkbench::HeadlessContext context;
  inkbench::Pipeline pipeline;
  inkbench::Settings settings = inkbench::load_settings(inkbench::project_file("data/scenes/paper.toml"));
  settings.image.width = 64;
  settings.image.height = 48;
  const inkbench::Image image = pipeline.at(settings).raw(inkbench::BufferName::final);
  std::printf("%d x %d x %d\n", image.width_px, image.height_px, image.channels);
}
