#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"
#include "sim/session/run/advice.h"
#include "sim/session/run/finished_run.h"
#include "sim/session/run/in_place.h"
#include "sim/session/run/run_request.h"

namespace csgsim::session {

/// Options of a picture of a model.
struct RenderRequest {
  ModelRequest model;
  RunRequest run;
  bool check = false;
  std::optional<std::uint64_t> max_wrong_pixels;

  void add_to(OptionList& options);
};

/// A model compiled for a machine, to be run.
struct Compiled {
  machines::Machine machine;
  CompiledModel model;
  std::vector<std::filesystem::path> inputs;  ///< the files that were read, the model's first
  bool is_text = false;                       ///< a text was read in place of the model's file

  /// `options` are those that it was compiled with. Both have to outlive what is returned.
  [[nodiscard]] RunSubject subject(const RenderRequest& request) const {
    return {.machine = machine,
            .program = model.program,
            .inputs = inputs,
            .hash = model.hash,
            .camera = &model.camera,
            .scene = &request.model.scene_values(),
            .halfspaces = [this, &request] { return halfspaces_of(model, request.model, machine); },
            .is_in_place = is_text};
  }
};

/// Puts into the request the bits that --max-wrong-pixels asks for: studies::choose_bits. Throws InputError.
using ChooseBits = std::function<void(RenderRequest&, const machines::Machine&, const model::Tree&)>;

/// Compiles the model, with the bits that are chosen, if the request leaves that open. Warns of faces nearly in one
/// plane. Throws InputError, UsageError.
Compiled compile(RenderRequest& request, const ChooseBits& choose, const InPlace& in_place = {});

/// Holds the picture against the exact one of the same half-spaces; none without --check. Options and model have to
/// outlive it. Throws InputError for what is see-through.
Judge judge_of(const RenderRequest& request, const Compiled& compiled);

/// What may be tried to better the run. Options and model have to outlive it.
Advice advice_of(const RenderRequest& request, const Compiled& compiled);

}  // namespace csgsim::session
