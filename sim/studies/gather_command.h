// The command csgsim gather.
// Used by sim/app.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/session/options/option_list.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

/// Options of csgsim gather.
struct GatherRequest {
  std::vector<std::string> folders;
  std::string output;
  std::string page;
  bool no_plots = false;
  bool missing = false;

  void add_to(session::OptionList& list);
};

/// Joins the shards of one of these studies and shows the results. Throws InputError as merge_shards() does and if
/// points are missing, and UsageError if the folder for the results is not specified.
void run_gather(std::span<const StudyRow* const> studies, const GatherRequest& options);

}  // namespace csgsim::studies
