#pragma once

#include <span>
#include <vector>

#include "host/emit/effect.h"
#include "host/emit/options.h"

/// The effects: a file each, and a row in rows.cpp.
namespace csgsim::effects {

/// In the order in which they are worked out.
std::span<const emit::Effect* const> all();

/// Their sections of a scene file.
std::vector<scene::Section> sections();

/// Those that the scene calls for.
std::vector<emit::CalledEffect> called_by(const scene::Scene& scene);

}  // namespace csgsim::effects
