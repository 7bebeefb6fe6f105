#include "sim/studies/gather_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "hw/base/text.h"
#include "sim/shell/options.h"
#include "sim/shell/usage.h"
#include "sim/shell/version.h"
#include "sim/studies/folder.h"
#include "sim/studies/gather.h"
#include "sim/studies/runner.h"

namespace csgsim::studies {

namespace {

struct Options {
  std::vector<std::string> folders;
  std::string output;
  std::string page;
  bool no_plots = false;
  bool missing = false;
};

/// Of one shard, for a shell.
std::string shard_command(const Gathered& gathered, unsigned number, const std::string& folder) {
  std::string line = "csgsim";
  for (const std::string& word :
       with_words(gathered.words, {"--shard", to_text(Shard{number, gathered.shards}), "-o", folder}))
    line += " " + shell_word(word);
  return line;
}

void refuse_missing(const Gathered& gathered, const std::string& folder) {
  if (gathered.missing == 0) return;
  const bool is_one = gathered.unfinished.size() == 1;
  throw InputError(fmt::format("{}: {} of {} points are missing: {} {} of {} {} not done; run {}{}", folder,
                               gathered.missing, gathered.rows.size(), is_one ? "shard" : "shards",
                               compact(gathered.unfinished), gathered.shards, is_one ? "is" : "are",
                               shard_command(gathered, gathered.unfinished.front(), folder),
                               is_one ? "" : "; csgsim gather --missing prints the command of each"));
}

void print_missing(const Gathered& gathered, const std::string& folder) {
  for (const unsigned number : gathered.unfinished) fmt::print("{}\n", shard_command(gathered, number, folder));
}

/// A command line of studies alone.
class StudyLine {
 public:
  explicit StudyLine(std::span<const StudyRow* const> studies) : line_("csgsim: studies that were gathered", "csgsim") {
    for (const StudyRow* const row : studies) {
      if (row->has_shards) commands_.push_back(describe(line_, *row));
    }
  }

  /// Returns the words as csgsim would write them in a shard. Throws UsageError for words that ask for no study.
  std::vector<std::string> read(std::vector<std::string> words) {
    return line_.read(std::move(words), options_without_effect);
  }

  [[nodiscard]] StudyCommand& at(std::string_view name) const {
    return **std::ranges::find_if(commands_, [&](const auto& one) { return one->row->name == name; });
  }

 private:
  shell::CommandLine line_;
  std::vector<std::shared_ptr<StudyCommand>> commands_;
};

/// What a shard says of its command is data: it has to be as csgsim writes it, a study with options that change a
/// result. So it names no file that is written or read besides.
void refuse_other_words(std::span<const StudyRow* const> studies, const Gathered& gathered) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(
        fmt::format("{}:1:1: its command is none that shards are of ({}); delete the file and run its "
                    "shard again, with csgsim {}",
                    gathered.first.native(), why, gathered.inputs.csgsim));
  };
  std::vector<std::string> words;
  try {
    words = StudyLine(studies).read(with_words(gathered.words, {"-o", "."}));  // which some studies need
  } catch (const shell::UsageError& error) {
    refuse(error.what());
  }
  if (words != gathered.words) refuse("csgsim writes '" + printable(fmt::format("{}", fmt::join(words, " "))) + "'");
}

std::vector<std::string> output_words(const std::string& output, const Options& options) {
  std::vector<std::string> words{"-o", output};
  if (!options.page.empty()) words.insert(words.end(), {"--report", options.page});
  if (options.no_plots) words.emplace_back("--no-plots");
  return words;
}

void tell_other_csgsim(const Gathered& gathered, const std::string& output) {
  const std::string here = shell::version_and_build();
  if (gathered.inputs.csgsim == here) return;
  tell_line(fmt::format("{}: measured by csgsim {}; this is {}", output, gathered.inputs.csgsim, here));
}

void run(std::span<const StudyRow* const> studies, const Options& options) {
  if (options.folders.size() > 1 && options.output.empty() && !options.missing)
    throw shell::UsageError("--output", "the shards are in several folders; name one for the results");
  const std::vector<std::filesystem::path> folders(options.folders.begin(), options.folders.end());
  const Gathered gathered = gather(folders);
  const std::string output = options.output.empty() ? options.folders.front() : options.output;
  refuse_other_words(studies, gathered);
  if (options.missing) return print_missing(gathered, options.folders.front());
  refuse_missing(gathered, options.folders.front());
  tell_other_csgsim(gathered, output);
  StudyLine line(studies);
  line.read(with_words(gathered.words, output_words(output, options)));
  show_gathered(line.at(gathered.words.front()), gathered);
}

}  // namespace

void add_gather(shell::CommandLine& line, std::span<const StudyRow* const> studies) {
  const auto options = std::make_shared<Options>();
  shell::Command command = line.add(
      "gather", "Join the shards of a study: the table, JSON and plots that one process makes",
      "Example:\n  csgsim sweep carburettor.csg --shard 1/2 -o out\n"
      "  csgsim sweep carburettor.csg --shard 2/2 -o out\n"
      "  csgsim gather out\n"
      "Shards may run at the same time, on any number of machines; what has been measured of one that was killed is\n"
      "kept, and the same command goes on. docs/cluster.md has scripts for Slurm, GNU Parallel and MPI launchers.");
  command.option("FOLDER", options->folders, "Where the shards were told to write, with -o").required();
  command.option("-o,--output", options->output, "Folder for the results; FOLDER if there is one only").folder();
  command.option("--report", options->page, "The study's page, for a browser").check(shell::not_empty);
  command.flag("--no-plots", options->no_plots, "Do without plots (gnuplot)");
  command.flag("--missing", options->missing, "Only print the command of each shard that is not done, a line each");
  command.prints_summary();
  command.runs([options, studies] { run(studies, *options); });
}

}  // namespace csgsim::studies
