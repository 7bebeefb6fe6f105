// Parses untrusted JSON within limits.
// Used by sim/session/model, sim/shell, sim/viewer and sim/web.
#pragma once

#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "hw/base/error.h"

namespace csgsim::session {

/// Limits of a JSON text from outside.
struct JsonLimits {
  int depth = 100;                                               ///< nesting depth of brackets
  std::size_t values = std::numeric_limits<std::size_t>::max();  ///< values, keys and brackets together
};

/// A JSON text exceeds a limit. The message names the limit.
class JsonLimitError : public InputError {
 public:
  using InputError::InputError;
};

/// Parses a JSON text from outside; every reader of such a text uses this function. nlohmann-json copies, compares and
/// writes values recursively and looks up members one after another, so the text must not determine depth or count.
/// Throws JsonLimitError, and nlohmann::ordered_json::exception for invalid JSON.
nlohmann::ordered_json parse_json(std::string_view text, const JsonLimits& limits);

}  // namespace csgsim::session
