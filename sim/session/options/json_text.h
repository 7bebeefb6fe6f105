#pragma once

#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "hw/base/error.h"

namespace csgsim::session {

/// What a JSON text from outside may hold.
struct JsonLimits {
  int depth = 100;                                               ///< brackets in brackets
  std::size_t values = std::numeric_limits<std::size_t>::max();  ///< with keys, and brackets
};

/// A JSON text passes a limit. The message names the limit.
class JsonLimitError : public InputError {
 public:
  using InputError::InputError;
};

/// The value of a JSON text that comes from outside: every reader of such a text uses this function. nlohmann-json
/// copies, compares and writes values by recursion, and looks up members one after another, so that neither depth nor
/// number may be the text's own choice. Throws JsonLimitError, and nlohmann::ordered_json::exception for what is no
/// JSON.
nlohmann::ordered_json parsed_json(std::string_view text, const JsonLimits& limits);

}  // namespace csgsim::session
