#pragma once

#include <span>
#include <vector>

#include "host/emit/effect.h"
#include "host/emit/options.h"

/// The effects: a file each, and a row in rows.cpp.
namespace csgsim::effects {

/// In the order in which they are worked out, flat shading first.
std::span<const emit::Effect* const> all();

/// Their sections of a scene file.
std::vector<scene::Section> sections();

}  // namespace csgsim::effects
