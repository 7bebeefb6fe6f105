#pragma once

#include <string>

#include "host/scene/schema.h"

namespace csgsim::scene {

/// A table of the section's keys in Markdown: values, defaults, meanings.
std::string keys_table(const Section& section);

/// What the key may be, in words, and the value as a scene file has it; empty where none is said, and for a table of
/// colours.
std::string allowed_text(const Key& key);
std::string value_text(const KeyValue& value);

}  // namespace csgsim::scene
