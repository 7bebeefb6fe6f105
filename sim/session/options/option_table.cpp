#include "sim/session/options/option_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <vector>

#include "hw/kinds/load.h"
#include "sim/session/options/lists.h"

namespace csgsim::session {

namespace {

constexpr std::string_view drawn = "Model and scene";
constexpr std::string_view view = "View";
constexpr std::string_view machine = "Machine";
constexpr std::string_view algorithm = "Algorithm and pixel memory";
constexpr std::string_view accuracy = "Accuracy";
constexpr std::string_view varied = "This command";
constexpr std::string_view run = "The run";
constexpr std::string_view outputs = "Outputs";
constexpr std::string_view further = "Further options";
constexpr std::string_view settings = "Settings files";
constexpr std::string_view messages = "Messages";
constexpr std::string_view operand;  // help lists operands before all options

/// Order of the headings in help.
constexpr auto subjects = std::to_array<std::string_view>(
    {varied, drawn, view, machine, algorithm, accuracy, run, outputs, settings, further, messages});

constexpr auto options = std::to_array<KnownOption>({
    {drawn, "scene", "FILE", FileRole::input},
    {drawn, "set", "KEY=VALUE"},
    {drawn, "colour-scheme"},
    {drawn, "imports-from", "FOLDER", FileRole::input},
    {drawn, "openscad-time", "SECONDS"},
    {drawn, "define", "NAME=VALUE"},
    {drawn, "parameters", "FILE", FileRole::input},
    {drawn, "parameter-set", "SET"},
    {drawn, "limit"},
    {drawn, "snap"},
    {drawn, "tolerance", "T|Tpx"},
    {drawn, "curves"},
    {view, "size", "WxH"},
    {view, "camera", "NUMBERS"},
    {view, "projection"},
    {view, "view-all"},
    {view, "near", "DISTANCE"},
    {view, "frames"},
    {view, "orbit", "DEGREES"},
    {view, "cameras", "FILE", FileRole::input},
    {machine, "machine", "NAME|FILE", FileRole::machines},
    {machine, "machines", "LIST", FileRole::machines},
    {machine, "command-set", "FILE", FileRole::input},
    {machine, "memory-bits"},
    {machine, "ideal"},
    {algorithm, "strategy"},
    {algorithm, "stack-bits"},
    {algorithm, "colouring"},
    {algorithm, "colour-bits"},
    {algorithm, "pruning"},
    {accuracy, "z-bits"},
    {accuracy, "fraction-bits"},
    {accuracy, "edge-on", "PART"},
    {accuracy, "check"},
    {accuracy, "max-wrong-pixels"},
    {varied, "max-bits"},
    {varied, "min-fps"},
    {varied, "min-colour-bits"},
    {varied, "alu-bits", "LIST"},
    {varied, "vary", "KEY=LIST"},
    {varied, "points", "N"},
    {varied, "seed", "N"},
    {varied, "search", "N"},
    {varied, "axes", "LIST"},
    {varied, "sensitivity"},
    {varied, "samples", "N"},
    {varied, "process", "NAME|FILE", FileRole::processes},
    {varied, "advice"},
    {varied, "pixel", "X,Y"},
    {varied, "probe", "X,Y|TREE"},
    {varied, "point", "X,Y,Z"},
    {varied, "why-not", "PRIMITIVE"},
    {varied, "window", "WINDOW"},
    {varied, "padding", "CLOCKS"},
    {varied, "at", "WHAT"},
    {varied, "views"},
    {varied, "knobs", "LIST"},
    {varied, "fragments", "LIST"},
    {varied, "sides", "LIST"},
    {varied, "with", "LIST"},
    {varied, "methods", "LIST"},
    {varied, "coherences", "LIST"},
    {varied, "shapes", "LIST"},
    {varied, "reduced", "LIST"},
    {varied, "directories", "LIST"},
    {varied, "bucket-sizes", "LIST"},
    {varied, "cast", "LIST"},
    {varied, "facet-test", "LIST"},
    {varied, "item-buffer", "LIST"},
    {varied, "mailboxes", "LIST"},
    {varied, "reflections"},
    {varied, "flatness", "LIST"},
    {varied, "repairs", "LIST"},
    {varied, "processors", "LIST", FileRole::processors},
    {varied, "levels"},
    {varied, "subdivisions"},
    {varied, "tolerances", "LIST"},
    {varied, "parts"},
    {varied, "resolution"},
    {varied, "rounds"},
    {varied, "seconds"},
    {varied, "list"},
    {varied, "compile"},
    {varied, "compare", "FILE", FileRole::input},
    {varied, "suite", "FOLDER", FileRole::input},
    {run, "level"},
    {run, "evaluator"},
    {run, "threads"},
    {run, "whole"},
    {run, "lanes"},
    {run, "commands", "FILE", FileRole::input},
    {run, "checkpoint", "FILE", FileRole::output},
    {run, "checkpoint-every"},
    {run, "resume", "FILE", FileRole::output},
    {run, "no-draw"},
    {run, "shard", "K/N"},
    {run, "from", "FOLDER", FileRole::input},
    {run, "anyway"},
    {run, "port"},
    {run, "evaluation-time", "SECONDS"},
    {run, "patience", "SECONDS"},
    {outputs, "output", "FILE", FileRole::output},
    {outputs, "ascii"},
    {outputs, "format"},
    {outputs, "depth", "FILE", FileRole::output},
    {outputs, "owner", "FILE", FileRole::output},
    {outputs, "surface"},
    {outputs, "stats", "FILE", FileRole::output},
    {outputs, "json", "FILE", FileRole::output},
    {outputs, "results", "FILE", FileRole::output},
    {outputs, "report", "FILE", FileRole::output},
    {outputs, "row-commands"},
    {outputs, "form"},
    {outputs, "no-plots"},
    {outputs, "missing"},
    {settings, "config", "FILE", FileRole::input},
    {settings, "dump-config"},
    {messages, "progress"},
    {messages, "timing"},
    {messages, "no-stories"},
    {messages, "verbose"},
    {messages, "quiet"},
    {messages, "help"},
    {messages, "version"},
    {operand, "model", "", FileRole::input},
    {operand, "program", "", FileRole::input},
    {operand, "a", "", FileRole::input},
    {operand, "b", "", FileRole::input},
    {operand, "file", "", FileRole::input},
    {operand, "name", "", FileRole::machines},
});

constexpr KnownOption other{further};

std::string file_in(std::string_view name, const std::string& folder) {
  const bool stays = name.empty() || name == "-" || folder.empty();
  return stays ? std::string(name) : (std::filesystem::path(folder) / name).native();
}

}  // namespace

const KnownOption& known_option(std::string_view option) {
  const bool is_of_one_side = option.ends_with("-a") || option.ends_with("-b");
  const std::string_view name = is_of_one_side ? option.substr(0, option.size() - 2) : option;
  const auto found = std::ranges::find(std::span(options), name, &KnownOption::name);
  return found == std::span(options).end() ? other : *found;
}

int heading_position(std::string_view subject) {
  return static_cast<int>(std::ranges::find(subjects, subject) - subjects.begin());
}

std::string resolve_in_folder(std::string_view option, const std::string& value, const std::string& folder) {
  const FileRole role = known_option(option).role;
  if (role == FileRole::none) return value;
  if (role == FileRole::input || role == FileRole::output) return file_in(value, folder);
  std::vector<std::string> names;
  for (const std::string_view one : split(value, ","))
    names.push_back(kinds::file_of(one).empty() ? std::string(one) : file_in(one, folder));
  return fmt::format("{}", fmt::join(names, ","));
}

}  // namespace csgsim::session
