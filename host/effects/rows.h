#pragma once

#include <span>
#include <vector>

#include "host/emit/effect.h"
#include "host/emit/options.h"
#include "host/model/tree.h"
#include "host/scene/scene.h"

/// The effects: a file each, which defines its row.
namespace csgsim::effects {

/// In the order in which they are worked out, flat shading first.
std::span<const emit::EffectRow* const> all();

/// Their sections of a scene file.
std::vector<scene::Section> sections();

/// The model as the effects that the scene calls for make it. Throws InputError where their settings do not fit it.
model::Tree reshaped(model::Tree&& tree, const scene::Scene& scene);

}  // namespace csgsim::effects
