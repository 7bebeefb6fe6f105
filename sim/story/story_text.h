// A pixel's history as text.
// Used by sim/story, sim/app and sim/report.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/story/phrases.h"
#include "sim/story/story.h"

namespace csgsim::story {

/// Text for the user: what the pixel shows and why, then the history with one event per line. Surfaces beside the pixel
/// are only summarized.
std::string text_of(const Subject& subject, const Story& story);

/// Whole lines of that text.
struct TextPart {
  std::string text;
  std::uint64_t end = 0;  ///< number after the last instruction of an event; 0 for other lines
};

/// text_of() in parts: what the pixel shows, then each event, with the lines between events.
std::vector<TextPart> parts_of(const Subject& subject, const Story& story);

}  // namespace csgsim::story
