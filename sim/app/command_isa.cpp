#include <fmt/format.h>

#include "hw/isa/manual.h"
#include "sim/app/commands.h"

namespace csgsim::app {

void add_isa(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("isa", "Print the manual page of the broadcast instruction set, in Markdown");
  command.footer("Example:\n  csgsim isa > docs/instruction-set.md");
  command.callback([] { fmt::print("{}", isa::instruction_set_page()); });
}

}  // namespace csgsim::app
