// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/commands.h"
#include "app/terminal.h"
#include "pipeline/settings/style_file.h"

namespace inkbench {

void add_styles_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("styles", "List the bundled stroke styles");
  command->footer("Example:\n  inkbench render --style pencil --out out/pencil");
  command->callback([] {
    size_t widest = 0;
    for (const std::string& name : style_names()) widest = std::max(widest, name.size());
    for (const std::string& name : style_names())
      print_out("{:<{}}  {}\n", name, widest, style_title(find_style(name, "", name)));
  });
}

}  // namespace inkbench
