// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands.h"
#include "app/terminal.h"
#include "pipeline/settings/params_table.h"

namespace inkbench {

void add_params_command(CLI::App& app) {
  auto format = std::make_shared<std::string>("text");
  CLI::App* command =
      app.add_subcommand("params", "List every parameter with its default, limits and meaning");
  command->add_option("--format", *format, "text, markdown or json")
      ->check(CLI::IsMember({"text", "markdown", "json"}));
  command->footer("Example:\n  inkbench params --format json");
  command->callback([format] {
    const TableFormat table = *format == "json"       ? TableFormat::json
                              : *format == "markdown" ? TableFormat::markdown
                                                      : TableFormat::text;
    print_out("{}", params_table(table));
  });
}

}  // namespace inkbench
