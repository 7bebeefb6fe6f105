#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "hw/machines/machine.h"
#include "sim/story/phrases.h"

namespace csgsim::story {

/// All that is told of a pixel.
struct Answer {
  std::string text;             ///< for people: why a primitive is not seen, if that is asked, and then the story
  nlohmann::ordered_json json;  ///< the same; docs/debugging.md describes every key with its unit
};

/// `missed`: a primitive of which it is asked why it is not seen there. Throws InputError as Teller and its story_of
/// do.
Answer answer_of(const Subject& subject, const machines::Machine& machine, std::uint32_t x, std::uint32_t y,
                 std::optional<std::uint32_t> missed);

}  // namespace csgsim::story
