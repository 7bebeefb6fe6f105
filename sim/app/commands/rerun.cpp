#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/messages.h"
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
  RunRequest run;  ///< outputs of the new run, and its progress
  std::string from;
  bool anyway = false;
};

void refuse(const RecordedRun& run, const std::vector<std::string>& changes, bool anyway) {
  if (changes.empty()) return;
  const std::string text = fmt::format("{}: {}", run.file, fmt::join(changes, "; "));
  if (!anyway) throw InputError(text + "; add --anyway to continue");
  report_line("warning: " + text);
}

/// The command line of the new run, with the outputs of this request instead of the recorded ones.
std::vector<std::string> words_of(const RecordedRun& run, const Options& options) {
  std::error_code error;
  const std::string here = fs::current_path(error).native();
  std::vector<std::string> words{recorded_command(run), "--progress=" + options.run.progress};
  const auto add = [&](const std::string& name, const std::string& file) {
    if (!file.empty()) words.push_back(fmt::format("--{}={}", name, resolve_in_folder(name, file, here)));
  };
  add("output", options.run.picture);
  add("depth", options.run.depth);
  add("owner", options.run.owner);
  add("stats", options.run.stats);
  return words;
}

void change_folder(const std::string& folder) {
  std::error_code error;
  fs::current_path(folder, error);
  if (error)
    throw InputError(folder + ": cannot change to this folder (" + error.message() +
                     "); name the folder in which the run was started with --from");
}

/// Result of the comparison. `is_done`: a run both began and ended.
struct Comparison {
  bool is_done = false;
  std::vector<std::string> differing;
};

void rerun(CommandLine& line, const Options& options) {
  const RecordedRun run = read_recorded_run(options.file);
  refuse_clashes(std::vector<fs::path>{options.file},
                 std::vector<fs::path>{options.run.picture, options.run.depth, options.run.owner, options.run.stats});
  const std::vector<Setting> settings = recorded_settings(run, line.options_of(recorded_command(run)));
  const std::vector<std::string> words = words_of(run, options);
  if (!options.from.empty()) change_folder(options.from);
  refuse(run, describe_changes_since(run), options.anyway);
  Comparison comparison;
  line.run(words, settings,
           {[&](const nlohmann::ordered_json& configuration) {
              refuse(run, describe_configuration_changes(run, configuration), options.anyway);
            },
            [&](const nlohmann::ordered_json& stats) {
              comparison = {true, describe_count_differences(run, stats)};
            }});
  if (!comparison.is_done) throw InputError(run.file + ": no run could be compared; use an unmodified stats file");
  if (!comparison.differing.empty()) {
    throw InputError(fmt::format("{}: the run differs: {}", run.file, fmt::join(comparison.differing, "; ")));
  }
  fmt::print("{:<18}the picture and all counts equal those of {}\n", "rerun", run.file);
}

void add_rerun(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command = line.add(
      "rerun", run_group, "Repeat the run recorded in a stats file and check that picture and counts match",
      "Example:\n  csgsim render carburettor.csg -o carburettor.png --stats carburettor.json\n  csgsim rerun "
      "carburettor.json -o again.png\nOnly the outputs named here are written, not those of the recorded run.");
  command.option("FILE", options->file, "The stats file, .json, of csgsim render or run").required();
  options->run.add_outputs_to(command);
  command.option("--from", options->from, "Folder in which the recorded run was started, if not the current one")
      .check(not_empty);
  command.flag("--anyway", options->anyway, "Continue even if csgsim or an input file has changed");
  add_progress_option(command, options->run.progress);
  command.add_quiet_option();
  command.set_action([&line, options] { rerun(line, *options); });
}

}  // namespace

extern const CommandRow rerun_row{.name = "rerun", .add = add_rerun, .needs_all_commands = true};

}  // namespace csgsim::app
