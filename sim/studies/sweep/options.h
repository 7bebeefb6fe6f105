// Options of csgsim sweep, and the points that they select.
// Used by csgsim sweep.
#pragma once

#include <string>
#include <vector>

#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"

namespace csgsim::studies {

/// Names of the default strategies, separated by commas.
std::string default_strategies();

/// Options of csgsim sweep. Lists and ranges are checked when the command line is parsed.
struct SweepOptions {
  session::ModelRequest view;
  std::vector<std::string> models;
  std::string machines = "pixel-planes-4";
  std::string memory_bits;
  std::string z_bits = "20";
  std::string strategies = default_strategies();
  std::string stack_bits = "3..8";
  std::string colourings = "rebroadcast";
  std::string prunings = "auto";
  std::string curves = "auto";
  bool no_draw = false;

  void add_to(session::OptionList& command);

  /// The requested points, as `csgsim render` would draw them.
  [[nodiscard]] std::vector<session::ModelRequest> designs() const;
};

}  // namespace csgsim::studies
