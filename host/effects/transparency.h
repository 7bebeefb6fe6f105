#pragma once

#include <optional>

#include "host/emit/effect.h"

namespace csgsim::effects {

extern const emit::Effect transparency;

/// The scene, with what is see-through drawn by screen-door, which takes no memory. None where the scene has a say in
/// it: it speaks of the effect, or its materials let something through.
std::optional<scene::Scene> by_screen_door(scene::Scene scene);

}  // namespace csgsim::effects
