// SPDX-License-Identifier: MIT
// What the workbench window writes for the command line does there what it says: sweeps run unchanged, the
// copied command draws the same settings, and both come back from the images that they leave.
#include "app/workbench/opened_file.h"
#include "app/workbench/param_changes.h"
#include "app/workbench/presets.h"
#include "app/workbench/render_command_text.h"
#include "app/workbench/sweep_builder.h"
#include "pipeline/settings/settings_file.h"
#include "tests/cli/cli_test.h"
#include "tests/places.h"

namespace inkbench {
namespace {

class WorkbenchCommands : public CliTest {
 protected:
  WorkbenchCommands() : scene_(write("scenes/small.toml", small_scene())), settings_(load_settings(scene_)) {
    settings_.combine.k_depth = 0.1F / 3.0F;
    settings_.camera.fov = 50;
    settings_.ramp.diffuse.stops = {{0.25F, {0.5F, 0.25F, 0.125F}, false}, {0.75F, glm::vec3(1), true}};
  }

  fs::path scene_;
  Settings settings_;
};

TEST_F(WorkbenchCommands, a_saved_sweep_runs_unchanged_with_the_windows_settings_in_each_cell) {
  const SweepRequest request{.axes = {{.key = "combine.threshold", .from = 0.25, .to = 0.75, .count = 3},
                                      suggested_axis(settings_, "combine.use_normal")}};
  save_study(draft_study(request, settings_, scene_, file("specs/sweep.toml")));
  ASSERT_TRUE(succeeds(inkbench({"study", "specs/sweep.toml", "--out", "out"})));
  int cells = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(file("out/cells"))) {
    const OpenedFile cell = open_file(entry.path());
    ASSERT_EQ(cell.kind, FileKind::exported_image);
    Settings expected = settings_;
    expected.combine.threshold = cell.settings->combine.threshold;
    expected.combine.use_normal = cell.settings->combine.use_normal;
    EXPECT_EQ(settings_text(*cell.settings), settings_text(expected));
    ++cells;
  }
  EXPECT_EQ(cells, 6);
  const OpenedFile grid = open_file(file("out/grid.png"));
  EXPECT_EQ(grid.kind, FileKind::study);
}

TEST_F(WorkbenchCommands, a_sweep_of_models_that_no_scene_has_runs_too) {
  settings_.models.pop_back();
  const SweepRequest request{.axes = {{.key = "combine.threshold", .from = 0.25, .to = 0.75, .count = 2}}};
  save_study(draft_study(request, settings_, scene_, file("specs/sweep.toml")));
  ASSERT_TRUE(succeeds(inkbench({"study", "specs/sweep.toml", "--out", "out"})));
  const OpenedFile cell = open_file(file("out/cells/0001_final.png"));
  EXPECT_TRUE(same_structure(*cell.settings, settings_));
}

TEST_F(WorkbenchCommands, the_copied_command_draws_the_windows_settings) {
  const RenderCommand command = render_command(settings_, scene_, {BufferName::depth}, "out/a b");
  const std::string program = std::string("inkbench() { '") + inkbench_program() + "' \"$@\"; }\n";
  const CommandResult result =
      run_command({"/bin/sh", "-c", program + command.text}, {.working_folder = file("")});
  ASSERT_TRUE(succeeds(result));
  const OpenedFile image = open_file(file("out/a b/depth.png"));
  EXPECT_EQ(image.buffer, BufferName::depth);
  EXPECT_EQ(settings_text(*image.settings), settings_text(settings_));
}

TEST_F(WorkbenchCommands, a_preset_is_a_scene_on_the_command_line) {
  const fs::path preset = PresetStore(file("presets")).save("my lines", settings_);
  ASSERT_TRUE(succeeds(inkbench({"render", "--scene", preset.string(), "--out", "out"})));
  EXPECT_EQ(settings_text(*open_file(file("out/final.png")).settings), settings_text(settings_));
}

}  // namespace
}  // namespace inkbench
