// Documentation of scene files, generated from their schema.
// Used by host/effects and sim/viewer.
#pragma once

#include <string>

#include "host/scene/schema.h"

namespace csgsim::scene {

/// The section's keys as a Markdown table of values, defaults and meanings.
std::string keys_table(const Section& section);

/// The allowed values of a key in words.
std::string allowed_text(const Key& key);

/// A value as written in a scene file. Empty if there is no value, and for a table of colours.
std::string value_text(const KeyValue& value);

}  // namespace csgsim::scene
