#pragma once

#include <string>

#include "host/scene/schema.h"

namespace csgsim::scene {

/// A table of the section's keys in Markdown: values, defaults, meanings.
std::string keys_table(const Section& section);

}  // namespace csgsim::scene
