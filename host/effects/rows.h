// The table of effects.
// Used by sim/session and sim/viewer.
#pragma once

#include <span>
#include <vector>

#include "host/emit/effect.h"
#include "host/emit/options.h"
#include "host/model/tree.h"
#include "host/scene/scene.h"

// Each effect is a file that defines its row.
namespace csgsim::effects {

/// The rows of all effects in the order of execution; flat shading is first.
std::span<const emit::EffectRow* const> all();

/// The effects' sections of a scene file.
std::vector<scene::Section> sections();

/// The model after the changes by effects that the scene requests. Throws InputError if the settings of an effect do
/// not fit the model.
model::Tree reshape_model(model::Tree&& tree, const scene::Scene& scene);

}  // namespace csgsim::effects
