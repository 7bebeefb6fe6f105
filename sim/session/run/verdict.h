// Accuracy of a picture compared with the exact one.
// Used by sim/session and sim/viewer.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sim/observe/frame.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"

namespace csgsim::session {

/// Compares the picture with the exact one of the same half-spaces. `json` receives the number of wrong pixels by kind,
/// for the stats; the return value is the same as a line of the summary. Throws InputError for transparent parts.
std::string verdict(const CompiledModel& compiled, const observe::Frame& frame, nlohmann::ordered_json& json);

}  // namespace csgsim::session
