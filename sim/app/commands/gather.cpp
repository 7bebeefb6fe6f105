#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/app/options.h"
#include "sim/app/studies/shard_run.h"
#include "sim/app/studies/studies.h"
#include "sim/app/studies/study_files.h"
#include "sim/app/usage.h"
#include "sim/app/version.h"

namespace csgsim::app {

namespace {

struct Options {
  std::vector<std::string> folders;
  std::string output;
  std::string page;
  bool no_plots = false;
  bool missing = false;
};

/// Of one shard, for a shell.
std::string shard_command(const study::Gathered& gathered, unsigned number, const std::string& folder) {
  std::string line = "csgsim";
  for (const std::string& word :
       with_words(gathered.words, {"--shard", study::to_text(study::Shard{number, gathered.shards}), "-o", folder}))
    line += " " + shell_word(word);
  return line;
}

void refuse_missing(const study::Gathered& gathered, const std::string& folder) {
  if (gathered.missing == 0) return;
  const bool is_one = gathered.unfinished.size() == 1;
  throw InputError(fmt::format("{}: {} of {} points are missing: {} {} of {} {} not done; run {}{}", folder,
                               gathered.missing, gathered.rows.size(), is_one ? "shard" : "shards",
                               study::compact(gathered.unfinished), gathered.shards, is_one ? "is" : "are",
                               shard_command(gathered, gathered.unfinished.front(), folder),
                               is_one ? "" : "; csgsim gather --missing prints the command of each"));
}

void print_missing(const study::Gathered& gathered, const std::string& folder) {
  for (const unsigned number : gathered.unfinished) fmt::print("{}\n", shard_command(gathered, number, folder));
}

void add_studies(CommandLine& line, const study::Gathered& gathered) {
#define CSGSIM_ADD_STUDY(name) gather_##name(line, gathered);
  CSGSIM_STUDIES(CSGSIM_ADD_STUDY)
#undef CSGSIM_ADD_STUDY
}

/// What a shard says of its command is data: it has to be as csgsim writes it, a study with options that change a
/// result. So it names no file that is written or read besides.
void refuse_other_words(const study::Gathered& gathered) {
  CommandLine line("csgsim: studies that were gathered", "csgsim");
  add_studies(line, gathered);
  const auto refuse = [&](const std::string& why) {
    throw InputError(
        fmt::format("{}:1:1: its command is none that shards are of ({}); delete the file and run its "
                    "shard again, with csgsim {}",
                    gathered.first.native(), why, gathered.inputs.csgsim));
  };
  std::vector<std::string> words;
  try {
    words = read_study_words(line, gathered.words);
  } catch (const UsageError& error) {
    refuse(error.what());
  }
  if (words != gathered.words) refuse("csgsim writes '" + printable(fmt::format("{}", fmt::join(words, " "))) + "'");
}

/// The study's own command does the rest: it finds that all has been measured.
void write_results(const study::Gathered& gathered, const std::string& output, const Options& options) {
  if (gathered.inputs.csgsim != version_and_build())
    tell_line(
        fmt::format("{}: measured by csgsim {}; this is {}", output, gathered.inputs.csgsim, version_and_build()));
  CommandLine line("csgsim: studies that were gathered", "csgsim");
  add_studies(line, gathered);
  std::vector<std::string> more{"-o", output};
  if (!options.page.empty()) more.insert(more.end(), {"--report", options.page});
  if (options.no_plots) more.emplace_back("--no-plots");
  std::vector<std::string> words = with_words(gathered.words, more);
  words.insert(words.begin(), "csgsim");
  std::vector<char*> arguments;
  arguments.reserve(words.size());
  for (std::string& word : words) arguments.push_back(word.data());
  line.run(arguments);
}

void run(const Options& options) {
  if (options.folders.size() > 1 && options.output.empty() && !options.missing)
    throw UsageError("--output", "the shards are in several folders; name one for the results");
  const std::vector<std::filesystem::path> studies(options.folders.begin(), options.folders.end());
  const study::Gathered gathered = study::gather(studies);
  refuse_other_words(gathered);
  if (options.missing) return print_missing(gathered, options.folders.front());
  refuse_missing(gathered, options.folders.front());
  write_results(gathered, options.output.empty() ? options.folders.front() : options.output, options);
}

}  // namespace

void add_gather(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command command = line.add(
      "gather", "Join the shards of a study: the table, JSON and plots that one process makes",
      "Example:\n  csgsim sweep carburettor.csg --shard 1/2 -o out\n"
      "  csgsim sweep carburettor.csg --shard 2/2 -o out\n"
      "  csgsim gather out\n"
      "Shards may run at the same time, on any number of machines; what has been measured of one that was killed is\n"
      "kept, and the same command goes on. docs/cluster.md has scripts for Slurm, GNU Parallel and MPI launchers.");
  command.option("FOLDER", options->folders, "Where the shards were told to write, with -o").required();
  command.option("-o,--output", options->output, "Folder for the results; FOLDER if there is one only")
      .check(not_empty);
  command.option("--report", options->page, "The study's page, for a browser").check(not_empty);
  command.flag("--no-plots", options->no_plots, "Do without plots (gnuplot)");
  command.flag("--missing", options->missing, "Only print the command of each shard that is not done, a line each");
  command.prints_summary();
  command.runs([options] { run(*options); });
}

}  // namespace csgsim::app
