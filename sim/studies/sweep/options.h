#pragma once

#include <string>
#include <vector>

#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"

namespace csgsim::studies {

/// Names of the strategies that are varied if none are named, with commas between them.
std::string usual_strategies();

/// Options of csgsim sweep. What a sweep varies are lists and ranges, checked when the command line is read.
struct SweepOptions {
  session::ModelRequest view;
  std::vector<std::string> models;
  std::string machines = "pixel-planes-4";
  std::string memory_bits;
  std::string z_bits = "20";
  std::string strategies = usual_strategies();
  std::string stack_bits = "3..8";
  std::string colourings = "rebroadcast";
  std::string prunings = "all";
  std::string curves = "auto";
  bool no_draw = false;

  void add_to(session::OptionList& command);

  /// The points asked for, as `csgsim render` would draw them.
  [[nodiscard]] std::vector<session::ModelRequest> designs() const;
};

}  // namespace csgsim::studies
