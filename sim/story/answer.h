// Text and JSON that explain a pixel.
// Used by sim/session and sim/viewer.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "hw/machines/machine.h"
#include "sim/story/phrases.h"

namespace csgsim::story {

/// The explanation of a pixel.
struct Answer {
  std::string text;             ///< text: why a primitive is not visible, if requested, and then the history
  nlohmann::ordered_json json;  ///< the same as JSON; docs/debugging.md describes every key with its unit
};

/// `missed`: a primitive for which the answer explains why it is not visible. Throws InputError as Teller and its
/// story_of do.
Answer answer_of(const Subject& subject, const machines::Machine& machine, std::uint32_t x, std::uint32_t y,
                 std::optional<std::uint32_t> missed);

}  // namespace csgsim::story
