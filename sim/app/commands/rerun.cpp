#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/session/options/option_table.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"
#include "sim/session/run/run_request.h"
#include "sim/shell/settings/recorded_run.h"

namespace csgsim::app {

namespace {

namespace fs = std::filesystem;

struct Options {
  std::string file;
  RunRequest run;  ///< what is written of the new run, and its progress
  std::string from;
  bool anyway = false;
};

void refuse(const RecordedRun& run, const std::vector<std::string>& changes, bool anyway) {
  if (changes.empty()) return;
  const std::string text = fmt::format("{}: {}", run.file, fmt::join(changes, "; "));
  if (!anyway) throw InputError(text + "; --anyway goes on");
  tell_line("warning: " + text);
}

/// The command, with what is written: of the stats file nothing names a file that is.
std::vector<std::string> words_of(const RecordedRun& run, const Options& options) {
  std::error_code error;
  const std::string here = fs::current_path(error).native();
  std::vector<std::string> words{command_of(run), "--progress=" + options.run.progress};
  const auto add = [&](const std::string& name, const std::string& file) {
    if (!file.empty()) words.push_back(fmt::format("--{}={}", name, in_folder(name, file, here)));
  };
  add("output", options.run.picture);
  add("depth", options.run.depth);
  add("owner", options.run.owner);
  add("stats", options.run.stats);
  return words;
}

void go_to(const std::string& folder) {
  std::error_code error;
  fs::current_path(folder, error);
  if (error) throw InputError(printable(folder) + ": it is no folder that can be gone to (" + error.message() + ")");
}

/// What the run showed. Only one that both began and ended has been compared.
struct Comparison {
  bool is_done = false;
  std::vector<std::string> differing;
};

void rerun(CommandLine& line, const Options& options) {
  const RecordedRun run = read_recorded_run(options.file);
  refuse_clashes(std::vector<fs::path>{options.file},
                 std::vector<fs::path>{options.run.picture, options.run.depth, options.run.owner, options.run.stats});
  const std::vector<Setting> settings = settings_of(run, line.options_of(command_of(run)));
  const std::vector<std::string> words = words_of(run, options);
  if (!options.from.empty()) go_to(options.from);
  refuse(run, changes_since(run), options.anyway);
  Comparison comparison;
  line.run(words, settings,
           {[&](const nlohmann::ordered_json& configuration) {
              refuse(run, changes_between(run, configuration), options.anyway);
            },
            [&](const nlohmann::ordered_json& stats) {
              comparison = {true, differences(run, stats)};
            }});
  if (!comparison.is_done)
    throw InputError(run.file + ": nothing was run that could be compared; take a stats file as csgsim wrote it");
  if (!comparison.differing.empty()) {
    throw InputError(fmt::format("{}: the run differs from it: {}", run.file, fmt::join(comparison.differing, "; ")));
  }
  fmt::print("{:<18}the picture and all counts are those of {}\n", "rerun", run.file);
}

void add_rerun(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command = line.add(
      "rerun", drawing, "Run again what a stats file tells of, and see that picture and counts are the same",
      "Example:\n  csgsim render carburettor.csg -o carburettor.png --stats carburettor.json\n  csgsim rerun "
      "carburettor.json -o again.png\nWhat was written then is not written again, but where an option here says so.");
  command.option("FILE", options->file, "The stats file, .json, of csgsim render or run").required();
  options->run.add_outputs_to(command);
  command.option("--from", options->from, "The folder in which the run was asked for, if it is not the current one")
      .check(not_empty);
  command.flag("--anyway", options->anyway, "Go on where csgsim or a file that was read is not as it was");
  add_progress(command, options->run.progress);
  command.prints_summary();
  command.runs([&line, options] { rerun(line, *options); });
}

}  // namespace

extern const CommandRow rerun_row{.name = "rerun", .add = add_rerun, .asks_others = true};

}  // namespace csgsim::app
