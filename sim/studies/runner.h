// Runs studies: options, tables, threads, shards, files and pages.
// Used by sim/app and sim/python.
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

/// A selected study with its options. The option list that describes them must outlive it.
struct StudyCommand {
  const StudyRow* row = nullptr;
  std::unique_ptr<Study> study;
  RunnerOptions options;
  session::OptionList& command;
  Folder folder = Folder::usual;  ///< optional for library callers
};

/// Adds the study's options to the list. Returns the command that the options fill.
std::shared_ptr<StudyCommand> add_study_options(session::OptionList& list, const StudyRow& row);

/// Adds the study's options to the list for a library caller, who receives the results: they are written only if a
/// folder is given, sharding is not available, and nothing is printed.
std::shared_ptr<StudyCommand> add_library_study_options(session::OptionList& list, const StudyRow& row);

/// Measures the points that are missing from the study's table, writes the results if there is a folder or a page, and
/// returns the text of the study's JSON file. An interrupted study throws Interrupted; its table keeps the measured
/// points.
std::string run_study_to_json(StudyCommand& request);

/// Measures the points that are missing from the study's table and shows all results.
void run_study(StudyCommand& request);

/// Shows the results of shards. The study's options must have been read.
void show_merged_shards(StudyCommand& request, const MergedShards& gathered);

/// A command line with further arguments inserted after the command's name.
std::vector<std::string> insert_words(const std::vector<std::string>& command,
                                      const std::vector<std::string>& added_words);

}  // namespace csgsim::studies
