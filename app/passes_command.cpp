// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>

#include "app/commands.h"
#include "pipeline/passes_table.h"

namespace inkbench {

void add_passes_command(CLI::App& app) {
  auto format = std::make_shared<PassesFormat>(PassesFormat::text);
  CLI::App* command = app.add_subcommand("passes", "List the passes: what each takes and gives");
  const std::map<std::string, PassesFormat> formats{
      {"text", PassesFormat::text}, {"markdown", PassesFormat::markdown}, {"dot", PassesFormat::dot}};
  command->add_option("--format", *format, "text, markdown, or dot for Graphviz")
      ->transform(CLI::CheckedTransformer(formats).description(""));
  command->footer("Example:\n  inkbench passes --format dot | dot -Tsvg -o passes.svg");
  command->callback([format] { fmt::print("{}", passes_table(*format)); });
}

}  // namespace inkbench
