#pragma once

#include <optional>

#include "host/scene/scene.h"

namespace csgsim::effects {

/// The scene, with what is see-through drawn by screen-door, which takes no memory. None where the scene has a say in
/// it: it speaks of the effect, or its materials let something through.
std::optional<scene::Scene> by_screen_door(scene::Scene scene);

}  // namespace csgsim::effects
