#include "sim/studies/gather_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "hw/base/text.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/usage.h"
#include "sim/session/options/version.h"
#include "sim/studies/folder.h"
#include "sim/studies/gather.h"
#include "sim/studies/runner.h"

namespace csgsim::studies {

namespace {

/// The words of a shard's command: as one of its runs had them, or else as another shard had them. Files of earlier
/// versions have only the words that affect results.
const std::vector<std::string>& words_of(const MergedShards& gathered, unsigned number) {
  const auto own = gathered.commands.find(number);
  if (own != gathered.commands.end()) return own->second.command;
  return gathered.commands.empty() ? gathered.words : gathered.commands.begin()->second.command;
}

/// The shell command that runs one shard.
std::string shard_command(const MergedShards& gathered, unsigned number, const std::string& folder) {
  return session::shell_command(
      insert_words(words_of(gathered, number), {"--shard", to_text(Shard{number, gathered.shards}), "-o", folder}));
}

/// The shell command that prints the commands of all incomplete shards.
std::string missing_command(const std::vector<std::string>& folders) {
  std::vector<std::string> words{"gather", "--missing"};
  if (std::ranges::any_of(folders, [](const std::string& folder) { return folder.starts_with('-'); }))
    words.emplace_back("--");
  words.insert(words.end(), folders.begin(), folders.end());
  return session::shell_command(words);
}

/// The message ends with one command, which can be copied as printed.
void refuse_missing(const MergedShards& gathered, const std::vector<std::string>& folders) {
  if (gathered.missing == 0) return;
  const bool is_one = gathered.unfinished.size() == 1;
  throw InputError(fmt::format(
      "{}: {} of {} points are missing: {} {} of {} {}", folders.front(), gathered.missing, gathered.rows.size(),
      is_one ? "shard" : "shards", ranges_text(gathered.unfinished), gathered.shards,
      is_one
          ? "is not complete; complete it by: " + shard_command(gathered, gathered.unfinished.front(), folders.front())
          : "are not complete; print the command of each by: " + missing_command(folders)));
}

void print_missing(const MergedShards& gathered, const std::string& folder) {
  for (const unsigned number : gathered.unfinished) fmt::print("{}\n", shard_command(gathered, number, folder));
}

/// The study that the words of a shard's command select. Throws UsageError if there is no such study.
class GatheredStudy {
 public:
  GatheredStudy(std::span<const StudyRow* const> studies, const std::vector<std::string>& words)
      : list_(words.front()), command_(add_study_options(list_, row_of(studies, words.front()))) {
    list_.flag("-q,--quiet", is_quiet_, "The flag that the terminal adds to each command");
    list_.give_words(std::span(words).subspan(1));
    list_.check_and_apply();
  }

  /// The words of the command line as this csgsim writes them into a shard's file, without the options `excluded_keys`.
  [[nodiscard]] std::vector<std::string> words(std::span<const std::string_view> excluded_keys) const {
    return list_.words(excluded_keys);
  }
  [[nodiscard]] StudyCommand& command() const { return *command_; }

 private:
  static const StudyRow& row_of(std::span<const StudyRow* const> studies, std::string_view name) {
    const auto is_named = [&](const StudyRow* row) { return row->has_shards && row->name == name; };
    const auto found = std::ranges::find_if(studies, is_named);
    if (found == studies.end()) throw session::UsageError(fmt::format("unknown study '{}'", name));
    return **found;
  }

  session::OptionList list_;
  std::shared_ptr<StudyCommand> command_;
  bool is_quiet_ = false;
};

/// A shard's command as csgsim writes it, without the options `excluded_keys`. Throws UsageError if it is not a
/// study's.
std::vector<std::string> rewrite_command(std::span<const StudyRow* const> studies,
                                         const std::vector<std::string>& words,
                                         std::span<const std::string_view> excluded_keys) {
  return GatheredStudy(studies, words).words(excluded_keys);
}

/// Throws InputError unless `words` equal what csgsim writes, which `write` returns.
void refuse_other_words(const MergedShards& gathered, const std::filesystem::path& file,
                        const std::vector<std::string>& words, const std::function<std::vector<std::string>()>& write) {
  std::string why;
  try {
    const std::vector<std::string> written = write();
    if (words == written) return;
    why = "csgsim writes '" + printable(fmt::format("{}", fmt::join(written, " "))) + "'";
  } catch (const session::UsageError& error) {
    why = error.what();
  }
  throw InputError(
      fmt::format("{}:1:1: the command is not one of a shard ({}); delete the file and run its "
                  "shard again, with csgsim {}",
                  file.native(), why, gathered.inputs.csgsim));
}

/// A shard's commands are untrusted input. They must be exactly as csgsim writes them: a study with the options that
/// affect results, and the same with other options. They therefore cannot name further files to be read or written.
void refuse_other_words(std::span<const StudyRow* const> studies, const MergedShards& gathered) {
  refuse_other_words(gathered, gathered.first, gathered.words,
                     [&] { return rewrite_command(studies, gathered.words, options_without_effect); });
  for (const auto& entry : gathered.commands) {
    const ShardFile& file = entry.second;
    refuse_other_words(gathered, file.path, file.command,
                       [&] { return rewrite_command(studies, file.command, options_of_shard); });
    refuse_other_words(gathered, file.path, gathered.words,
                       [&] { return rewrite_command(studies, file.command, options_without_effect); });
  }
}

std::vector<std::string> output_words(const std::string& output, const GatherRequest& options) {
  std::vector<std::string> words{"--output", output};
  if (!options.page.empty()) words.insert(words.end(), {"--report", options.page});
  if (options.no_plots) words.emplace_back("--no-plots");
  return words;
}

void warn_other_version(const MergedShards& gathered, const std::string& output) {
  const std::string here = session::version_and_build();
  if (gathered.inputs.csgsim == here) return;
  report_line(fmt::format("{}: measured by csgsim {}; this is {}", output, gathered.inputs.csgsim, here));
}

}  // namespace

void GatherRequest::add_to(session::OptionList& list) {
  list.option("FOLDER", folders, "The output (-o) of each shard").required();
  list.option("-o,--output", output, "Folder for the results; default: FOLDER if there is only one").folder();
  list.option("--report", page, "Write the study's page, for a browser").check(session::not_empty);
  list.flag("--no-plots", no_plots, "Omit plots (drawn by gnuplot)");
  list.flag("--missing", missing, "Only print the command of each incomplete shard, one per line");
}

void run_gather(std::span<const StudyRow* const> studies, const GatherRequest& options) {
  if (options.folders.size() > 1 && options.output.empty() && !options.missing)
    throw session::UsageError("--output", "the shards are in several folders; specify one for the results");
  const std::vector<std::filesystem::path> folders(options.folders.begin(), options.folders.end());
  const MergedShards gathered = merge_shards(folders);
  const std::string output = options.output.empty() ? options.folders.front() : options.output;
  refuse_other_words(studies, gathered);
  if (options.missing) return print_missing(gathered, options.folders.front());
  refuse_missing(gathered, options.folders);
  warn_other_version(gathered, output);
  const GatheredStudy study(studies, insert_words(gathered.words, output_words(output, options)));
  show_merged_shards(study.command(), gathered);
}

}  // namespace csgsim::studies
