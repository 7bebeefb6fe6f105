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
struct PixelExplanation {
  std::string text;             ///< why a primitive is not visible, if requested, followed by the history
  nlohmann::ordered_json json;  ///< the explanation as JSON; docs/debugging.md describes every key with its unit
};

/// Explains the pixel and, if `missing` is given, why that primitive is not visible there. Throws InputError like
/// StoryBuilder and StoryBuilder::story_of.
PixelExplanation explain_pixel(const Subject& subject, const machines::Machine& machine, std::uint32_t x,
                               std::uint32_t y, std::optional<std::uint32_t> missing);

}  // namespace csgsim::story
