#include <fmt/format.h>

#include "hw/isa/manual.h"
#include "sim/app/commands/commands.h"

namespace csgsim::app {

void add_isa(CommandLine& line) {
  Command command = line.add("isa", "Print the manual page of the broadcast instruction set, in Markdown",
                             "Example:\n  csgsim isa > docs/instruction-set.md");
  command.runs([] { fmt::print("{}", isa::instruction_set_page()); });
}

}  // namespace csgsim::app
