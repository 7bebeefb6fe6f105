#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/session/options/option_list.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

/// What shards have measured, to be joined.
struct GatherRequest {
  std::vector<std::string> folders;
  std::string output;
  std::string page;
  bool no_plots = false;
  bool missing = false;

  void add_to(session::OptionList& list);
};

/// Joins shards of one of these studies, and shows it. Throws InputError, UsageError.
void run_gather(std::span<const StudyRow* const> studies, const GatherRequest& options);

}  // namespace csgsim::studies
