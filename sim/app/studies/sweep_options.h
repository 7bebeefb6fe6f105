#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "sim/app/command_line.h"
#include "sim/app/model_options.h"
#include "sim/app/report_option.h"
#include "sim/study/shard.h"
#include "sim/study/sweep_run.h"

namespace csgsim::app {

/// Options of csgsim sweep. What a sweep varies are lists and ranges, checked when the command line is read.
struct SweepOptions {
  ModelOptions view;
  std::vector<std::string> models;
  std::string machines = "pixel-planes-4";
  std::string memory_bits;
  std::string z_bits = "20";
  std::string strategies = "stack,list,bits,products,parallel";
  std::string stack_bits = "3..8";
  std::string colourings = "rebroadcast";
  std::string prunings = "all";
  std::string curves = "auto";
  std::string folder;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::optional<study::Shard> shard;
  bool no_draw = false;
  bool no_plots = false;
  ReportOption report;
  std::string progress = "auto";

  void add_to(Command& command);
};

/// The points asked for, with all that they are made from; each model is read once for each picture size. One that
/// cannot be read is the reason of all its points. Throws InputError for machines.
std::vector<study::SweepJob> jobs_of(const SweepOptions& options);

}  // namespace csgsim::app
