#include <fmt/format.h>

#include "host/effects/manual.h"
#include "sim/app/commands/commands.h"

namespace csgsim::app {

void add_scene(CommandLine& line) {
  Command command = line.add("scene", "Print the manual page of scene files and their effects, in Markdown",
                             "Example:\n  csgsim scene > docs/scene-files.md");
  command.runs([] { fmt::print("{}", effects::scene_page()); });
}

}  // namespace csgsim::app
