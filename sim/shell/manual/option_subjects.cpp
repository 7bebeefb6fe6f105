#include "sim/shell/manual/option_subjects.h"

#include <algorithm>
#include <array>

namespace csgsim::shell {

namespace {

constexpr std::string_view drawn = "What is drawn";
constexpr std::string_view view = "View";
constexpr std::string_view machine = "Machine";
constexpr std::string_view algorithm = "Algorithm and pixel memory";
constexpr std::string_view accuracy = "Accuracy";
constexpr std::string_view varied = "What is varied or asked";
constexpr std::string_view run = "The run";
constexpr std::string_view outputs = "Outputs";
constexpr std::string_view further = "Further options";
constexpr std::string_view settings = "Settings files";
constexpr std::string_view messages = "Messages";

/// In the order of help.
constexpr auto subjects = std::to_array<std::string_view>(
    {varied, drawn, view, machine, algorithm, accuracy, run, outputs, settings, further, messages});

constexpr auto options = std::to_array<OptionSubject>({
    {drawn, "scene", "FILE"},
    {drawn, "set", "KEY=VALUE"},
    {drawn, "set-a", "KEY=VALUE"},
    {drawn, "set-b", "KEY=VALUE"},
    {drawn, "colour-scheme", ""},
    {drawn, "imports-from", "FOLDER"},
    {drawn, "openscad-time", "SECONDS"},
    {drawn, "limit", ""},
    {drawn, "snap", ""},
    {drawn, "tolerance", "T|Tpx"},
    {drawn, "curves", ""},
    {view, "size", "WxH"},
    {view, "camera", "NUMBERS"},
    {view, "projection", ""},
    {view, "view-all", ""},
    {view, "near", "DISTANCE"},
    {view, "frames", ""},
    {view, "turn", "DEGREES"},
    {machine, "machine", "NAME|FILE"},
    {machine, "machine-a", "NAME|FILE"},
    {machine, "machine-b", "NAME|FILE"},
    {machine, "machines", "LIST"},
    {machine, "memory-bits", ""},
    {machine, "ideal", ""},
    {algorithm, "strategy", ""},
    {algorithm, "strategy-a", ""},
    {algorithm, "strategy-b", ""},
    {algorithm, "stack-bits", ""},
    {algorithm, "colouring", ""},
    {algorithm, "colour-bits", ""},
    {algorithm, "pruning", ""},
    {algorithm, "pruning-a", ""},
    {algorithm, "pruning-b", ""},
    {accuracy, "z-bits", ""},
    {accuracy, "fraction-bits", ""},
    {accuracy, "edge-on", "PART"},
    {accuracy, "check", ""},
    {accuracy, "max-wrong-pixels", ""},
    {varied, "max-bits", ""},
    {varied, "min-fps", ""},
    {varied, "min-colour-bits", ""},
    {varied, "alu-bits", "LIST"},
    {varied, "advice", ""},
    {varied, "pixel", "X,Y"},
    {varied, "probe", "X,Y|TREE"},
    {varied, "point", "X,Y,Z"},
    {varied, "why-not", "PRIMITIVE"},
    {varied, "window", "WINDOW"},
    {varied, "at", "WHAT"},
    {varied, "views", ""},
    {varied, "knobs", "LIST"},
    {varied, "fragments", "LIST"},
    {varied, "sides", "LIST"},
    {varied, "levels", ""},
    {varied, "subdivisions", ""},
    {varied, "tolerances", "LIST"},
    {varied, "parts", ""},
    {varied, "rounds", ""},
    {varied, "seconds", ""},
    {run, "level", ""},
    {run, "level-a", ""},
    {run, "level-b", ""},
    {run, "threads", ""},
    {run, "whole", ""},
    {run, "commands", "FILE"},
    {run, "checkpoint", "FILE"},
    {run, "checkpoint-every", ""},
    {run, "resume", "FILE"},
    {run, "no-draw", ""},
    {run, "shard", "K/N"},
    {run, "from", "FOLDER"},
    {run, "anyway", ""},
    {outputs, "output", "FILE"},
    {outputs, "depth", "FILE"},
    {outputs, "owner", "FILE"},
    {outputs, "surface", ""},
    {outputs, "stats", "FILE"},
    {outputs, "json", "FILE"},
    {outputs, "report", "FILE"},
    {outputs, "no-plots", ""},
    {outputs, "missing", ""},
    {settings, "config", "FILE"},
    {settings, "dump-config", ""},
    {messages, "progress", ""},
    {messages, "timing", ""},
    {messages, "no-stories", ""},
    {messages, "quiet", ""},
    {messages, "help", ""},
    {messages, "version", ""},
});

constexpr OptionSubject other{further, "", ""};

struct CommandSubject {
  std::string_view subject;
  std::string_view command;
};

constexpr std::string_view drawing = "Models and Programs";
constexpr std::string_view looking = "Looking into a run";
constexpr std::string_view studies = "Studies";
constexpr std::string_view manuals = "Manual";

/// All other commands are studies.
constexpr auto commands = std::to_array<CommandSubject>({
    {drawing, "render"},
    {drawing, "compile"},
    {drawing, "run"},
    {drawing, "rerun"},
    {drawing, "disasm"},
    {looking, "debug"},
    {looking, "diff"},
    {looking, "explain"},
    {looking, "wave"},
    {manuals, "manual"},
});

}  // namespace

const OptionSubject& subject_of_option(std::string_view option) {
  const auto* const found = std::ranges::find(options, option, &OptionSubject::option);
  return found == options.end() ? other : *found;
}

int place_of_subject(std::string_view subject) {
  return static_cast<int>(std::ranges::find(subjects, subject) - subjects.begin());
}

std::string_view subject_of_command(std::string_view command) {
  const auto* const found = std::ranges::find(commands, command, &CommandSubject::command);
  return found == commands.end() ? studies : found->subject;
}

}  // namespace csgsim::shell
