#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/session/options/option_list.h"
#include "sim/session/run/report_option.h"
#include "sim/studies/gather.h"
#include "sim/studies/shard.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

/// Options that every study has.
struct RunnerOptions {
  std::string folder;
  unsigned threads = 0;
  std::optional<Shard> shard;
  bool no_plots = false;
  session::ReportOption report;
  std::string progress = "auto";
};

/// A study that is asked for, with its options, which are described by a list that outlives it.
struct StudyCommand {
  const StudyRow* row = nullptr;
  std::unique_ptr<Study> study;
  RunnerOptions options;
  session::OptionList& command;
  Folder folder = Folder::named;  ///< the row's, or optional for callers
};

/// Describes the study's options in the list.
std::shared_ptr<StudyCommand> describe(session::OptionList& list, const StudyRow& row);

/// The same for a caller, who gets what is measured: it is kept only in a folder that is asked for, is not shared out,
/// and nothing is printed.
std::shared_ptr<StudyCommand> describe_for_caller(session::OptionList& list, const StudyRow& row);

/// Measures what the study's table has not yet, writes all if there is a folder or a page, and returns the text of the
/// study's JSON file. An Interruptible study ends with Interrupted; its table has what had been measured.
std::string conduct(StudyCommand& asked);

/// Measures what the study's table has not yet, and shows all.
void run_study(StudyCommand& asked);

/// Shows what shards have measured as the study that its options ask for, which have been read.
void show_gathered(StudyCommand& asked, const Gathered& gathered);

/// The command with these words behind its name, before those that it was given.
std::vector<std::string> with_words(const std::vector<std::string>& command, const std::vector<std::string>& more);

}  // namespace csgsim::studies
