// SPDX-License-Identifier: MIT
#include <memory>
#include <string>

#include "app/commands.h"
#include "app/terminal.h"
#include "pipeline/passes_table.h"

namespace inkbench {

void add_passes_command(CLI::App& app) {
  auto format = std::make_shared<std::string>("text");
  CLI::App* command = app.add_subcommand("passes", "List the passes: what each takes and gives");
  command->add_option("--format", *format, "text, markdown, or dot for Graphviz")
      ->check(CLI::IsMember({"text", "markdown", "dot"}));
  command->footer("Example:\n  inkbench passes --format dot | dot -Tsvg -o passes.svg");
  command->callback([format] {
    const PassesFormat wanted = *format == "dot"        ? PassesFormat::dot
                                : *format == "markdown" ? PassesFormat::markdown
                                                        : PassesFormat::text;
    print_out("{}", passes_table(wanted));
  });
}

}  // namespace inkbench
