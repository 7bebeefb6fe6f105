// A pixel's history as JSON.
// Used by answer.cpp.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/story/phrases.h"
#include "sim/story/story.h"
#include "sim/story/why_not.h"

namespace csgsim::story {

/// The whole history; docs/debugging.md describes every key with its unit.
nlohmann::ordered_json to_json(const Subject& subject, const Story& story);

/// The answer to --why-not for one primitive.
nlohmann::ordered_json to_json(const Subject& subject, const Story& story, const WhyNot& answer);

}  // namespace csgsim::story
