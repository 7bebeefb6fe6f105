#pragma once

#include <string>

#include "sim/calls/in_place.h"
#include "sim/shell/command_line.h"
#include "sim/shell/model_options.h"
#include "sim/story/answer.h"

namespace csgsim::calls {

using namespace shell;  // whose options these are

/// Options of a pixel's story.
struct ExplainOptions {
  ModelOptions model;
  std::string pixel;
  std::string point;
  std::string why_not;

  void add_to(Command& command);
};

/// Throws UsageError where it is not said which pixel, or what is said is not for a Program.
void refuse_misuse(const ExplainOptions& options, const Command& command, const InPlace& in_place = {});

/// Throws InputError, UsageError.
story::Answer explain(const ExplainOptions& options, const Command& command, const InPlace& in_place = {});

}  // namespace csgsim::calls
