#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sim/observe/frame.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"

namespace csgsim::session {

/// Holds the picture against the exact one of the same half-spaces: `json` becomes how many pixels are wrong, and in
/// what, as the stats have it. Returns the same as a line of a summary. Throws InputError where something is
/// see-through.
std::string verdict(const CompiledModel& compiled, const ModelRequest& request, const observe::Frame& frame,
                    nlohmann::ordered_json& json);

}  // namespace csgsim::session
