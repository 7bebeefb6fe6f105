#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/shell/command_line.h"
#include "sim/shell/report_option.h"
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
  shell::ReportOption report;
  std::string progress = "auto";
};

/// A study on a command line, with its options.
struct StudyCommand {
  const StudyRow* row = nullptr;
  std::unique_ptr<Study> study;
  RunnerOptions options;
  shell::Command command;
};

/// Describes the study's command on the line, without saying what it does.
std::shared_ptr<StudyCommand> describe(shell::CommandLine& line, const StudyRow& row);

/// Adds the study to the line: its command measures what its table has not yet, and shows all.
void add_study(shell::CommandLine& line, const StudyRow& row);

/// Shows what shards have measured as the study that its options ask for, which have been read.
void show_gathered(StudyCommand& asked, const Gathered& gathered);

/// The command with these words behind its name, before those that it was given.
std::vector<std::string> with_words(const std::vector<std::string>& command, const std::vector<std::string>& more);

}  // namespace csgsim::studies
