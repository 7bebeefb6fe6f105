// Options of csgsim explore, and the designs that they select.
// Used by csgsim explore.
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
#include "sim/studies/sensitivity/variants.h"

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
  bool sensitivity = false;
  std::optional<std::uint32_t> samples{};  ///< of all figures together; only with `sensitivity`

  void add_to(session::OptionList& command);

  /// The requested designs, without a model. Throws UsageError, or InputError for machines.
  [[nodiscard]] DesignGrid designs() const;

  /// The axes of --axes, or the default axes.
  [[nodiscard]] std::string requested_axes() const;

  /// The process of --process; empty if there is none. Throws UsageError, or InputError if its file is invalid.
  [[nodiscard]] std::optional<process::Process> loaded_process() const;

  /// The variants of each design: with `sensitivity` those of the assumed figures, otherwise the design as it is.
  /// Throws UsageError, or InputError if a file is invalid.
  [[nodiscard]] Variants variants() const;

  /// Whether the memory bits per pixel are specified.
  [[nodiscard]] bool has_memory(const session::ModelRequest& design) const;
};

/// Options of the study that are not passed on to the command that draws a design.
std::vector<std::string> own_explore_options();

/// The `csgsim render` command of the row's point, with the clock given by its process, `memory_bits` per pixel and the
/// study's options, quoted for a POSIX shell.
std::string render_command(const ExploreOptions& options, const session::OptionList& command, const ExploreRow& row,
                           std::uint32_t memory_bits, const std::string& picture);

}  // namespace csgsim::studies
