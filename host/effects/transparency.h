// The screen-door variant of a scene, for machines with little memory.
// Used by sessions.
#pragma once

#include <optional>

#include "host/scene/scene.h"

namespace csgsim::effects {

/// The scene with transparent primitives drawn by screen-door, which takes no memory. Empty if the scene sets the
/// effect or its materials are transparent.
std::optional<scene::Scene> by_screen_door(scene::Scene scene);

}  // namespace csgsim::effects
