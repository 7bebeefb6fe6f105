#pragma once

#include <string>

#include "sim/story/phrases.h"
#include "sim/story/story.h"

namespace csgsim::story {

/// For people: what the pixel shows and why, then the story, an event a line. Surfaces that are beside the pixel are
/// counted, not told.
std::string text_of(const Subject& subject, const Story& story);

}  // namespace csgsim::story
