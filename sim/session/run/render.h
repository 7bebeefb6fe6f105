// The request behind csgsim render.
// Used by frames.h, sim/app, sim/python and sim/studies.
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

/// Options of drawing a model.
struct RenderRequest {
  ModelRequest model;
  RunRequest run;
  bool check = false;
  std::optional<std::uint64_t> max_wrong_pixels;

  void add_to(OptionList& options);
};

/// A model compiled for a machine, ready to run.
struct Compiled {
  machines::Machine machine;
  CompiledModel model;
  std::vector<std::filesystem::path> inputs;  ///< input files, the model's first
  bool is_text = false;                       ///< a text replaced the content of the model's file

  /// `request` is the one it was compiled from. Both have to outlive the result.
  [[nodiscard]] RunSubject subject(const RenderRequest& request) const {
    return {.machine = machine,
            .program = model.program,
            .inputs = inputs,
            .hash = model.hash,
            .camera = &model.camera,
            .scene = &request.model.scene_values(),
            .halfspaces = [this] { return halfspaces_of(model); },
            .is_in_place = is_text};
  }
};

/// Sets the bits in the request so that they meet --max-wrong-pixels, as studies::choose_bits does. Throws InputError.
using ChooseBits = std::function<void(RenderRequest&, const machines::Machine&, const model::Tree&)>;

/// Compiles the model, with chosen bits if --max-wrong-pixels is given. Warns about nearly coplanar faces. Throws
/// InputError, UsageError.
Compiled compile(RenderRequest& request, const ChooseBits& choose, const ContentReplacement& in_place = {});

/// Compares the picture with the exact one of the same half-spaces; empty without --check. Options and model have to
/// outlive it. Throws InputError for transparent parts.
Judge make_judge(const RenderRequest& request, const Compiled& compiled);

/// Changes to try that may speed the run up. Options and model have to outlive the result.
Advice advice_of(const RenderRequest& request, const Compiled& compiled);

}  // namespace csgsim::session
