#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "sim/app/command_line.h"
#include "sim/app/machine_list.h"
#include "sim/app/model_options.h"
#include "sim/app/report_option.h"
#include "sim/study/corpus.h"
#include "sim/study/shard.h"

namespace csgsim::app {

/// Options of csgsim corpus.
struct CorpusOptions {
  ModelOptions view;
  std::vector<std::string> models;  ///< files and folders
  std::string machines = all_machines();
  std::string folder;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::optional<study::Shard> shard;
  bool no_plots = false;
  std::string progress = "auto";
  ReportOption report;

  void add_to(Command& command);
};

/// The files themselves, and of each folder, and those in it, all .csg and .scad, by name; a .scad beside the .csg of
/// its own name is left out. None is named twice. Throws InputError for a folder without any.
std::vector<std::string> corpus_files(const std::vector<std::string>& names);

/// A job for each model on each machine, model after model: the order of the rows. Each model is read once for each
/// picture size; one that cannot be read is the reason of its jobs. Throws InputError for machines.
std::vector<study::CorpusJob> corpus_jobs(const CorpusOptions& options);

}  // namespace csgsim::app
