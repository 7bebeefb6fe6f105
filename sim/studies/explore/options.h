#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hw/process/process.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"
#include "sim/studies/design/grid.h"
#include "sim/studies/design/row.h"

namespace csgsim::studies {

/// Options of csgsim explore.
struct ExploreOptions {
  session::ModelRequest model;
  std::vector<std::string> models;
  std::vector<std::string> vary;
  std::uint32_t points = 0;
  std::uint32_t seed = 1;
  std::uint32_t search = 0;
  std::string axes;
  std::string process;

  void add_to(session::OptionList& command);

  /// The designs asked for, without a model. Throws UsageError, or InputError for machines.
  [[nodiscard]] DesignGrid designs() const;

  /// Those of --axes, or the usual ones.
  [[nodiscard]] std::string asked_axes() const;

  /// Throws UsageError, or InputError for what its file holds.
  [[nodiscard]] std::optional<process::Process> loaded_process() const;

  /// Whether somebody said how many memory bits a pixel has.
  [[nodiscard]] bool has_memory(const session::ModelRequest& design) const;
};

/// Options that the command which draws a design does not have from the study's.
std::vector<std::string> own_explore_options();

/// `csgsim render` of the row's point, with the clock that its process leaves, with so many memory bits a pixel and the
/// options of the study, as a POSIX shell takes it.
std::string render_command(const ExploreOptions& options, const session::OptionList& command, const ExploreRow& row,
                           std::uint32_t memory_bits, const std::string& picture);

}  // namespace csgsim::studies
