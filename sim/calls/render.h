#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/calls/in_place.h"
#include "sim/shell/advice.h"
#include "sim/shell/compiled_model.h"
#include "sim/shell/finished_run.h"
#include "sim/shell/model_options.h"
#include "sim/shell/run_options.h"

namespace csgsim::calls {

using namespace shell;  // whose options these are

/// Options of a picture of a model.
struct RenderOptions {
  ModelOptions model;
  RunOptions run;
  bool check = false;
  std::optional<std::uint64_t> max_wrong_pixels;

  void add_to(Command& command);
};

/// A model compiled for a machine, to be run.
struct Compiled {
  machines::Machine machine;
  CompiledModel model;
  std::vector<std::filesystem::path> inputs;  ///< the files that were read, the model's first
  bool is_text = false;                       ///< a text was read in place of the model's file

  /// `options` are those that it was compiled with. Both have to outlive what is returned.
  [[nodiscard]] RunSubject subject(const RenderOptions& options) const {
    return {.machine = machine,
            .program = model.program,
            .inputs = inputs,
            .hash = model.hash,
            .camera = &model.camera,
            .scene = &options.model.scene_values(),
            .halfspaces = [this, &options] { return halfspaces_of(model, options.model, machine); },
            .is_in_place = is_text};
  }
};

/// Compiles the model, with the bits that --max-wrong-pixels chooses, which the options get. Warns of faces nearly in
/// one plane. Throws InputError, UsageError.
Compiled compile(RenderOptions& options, const InPlace& in_place = {});

/// Holds the picture against the exact one of the same half-spaces; none without --check. Options and model have to
/// outlive it. Throws InputError for what is see-through.
Judge judge_of(const RenderOptions& options, const Compiled& compiled);

/// What may be tried to better the run. Options and model have to outlive it.
Advice advice_of(const RenderOptions& options, const Compiled& compiled);

}  // namespace csgsim::calls
