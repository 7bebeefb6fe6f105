#include "host/effects/manual.h"

#include <fmt/format.h>

#include "host/effects/rows.h"
#include "host/scene/manual.h"

namespace csgsim::effects {

namespace {

constexpr std::string_view introduction =
    "# Scene files\n\n"
    "Output of `csgsim manual scenes`. A scene holds everything about a picture except the model's solids: `csgsim "
    "render MODEL --scene scene.toml`.\nEvery key can also be set on the command line, with or without a file; it "
    "overrides the file's: "
    "`--set lights.0.direction=0,0,-1`, `--set\neffects.smooth.on=true`.\n"
    "Lists, written as `[[name]]`, have a table for each entry.\n";

std::string heading(const scene::Section& section) {
  return section.is_list ? fmt::format("[[{}]]", section.name) : fmt::format("[{}]", section.name);
}

void append_section(std::string& page, const scene::Section& section, std::string_view technique) {
  page += fmt::format("\n## `{}`\n\n{}\n", heading(section), section.meaning);
  if (!technique.empty()) page += fmt::format("\nTechnique: {}.\n", technique);
  const std::string table = scene::keys_table(section);
  if (!table.empty()) page += "\n" + table;
}

}  // namespace

std::string scene_page() {
  std::string page(introduction);
  for (const scene::Section& section : scene::common_sections()) append_section(page, section, "");
  page +=
      "\n# Effects\n\nThe section of an effect turns it on; `on = false` in a section turns it off, even "
      "where the model\ncalls for it. Costs: [Effects](effects.md).\n";
  for (const emit::EffectRow* const row : all()) append_section(page, row->section, row->technique);
  return page;
}

}  // namespace csgsim::effects
