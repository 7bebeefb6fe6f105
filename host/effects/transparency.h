// The screen-door variant of a scene, for machines with little memory.
// Used by sim/session.
#pragma once

#include <optional>

#include "host/scene/scene.h"

namespace csgsim::effects {

/// The scene with its transparent primitives drawn as screen-door patterns, which need no memory. Empty if the scene
/// requests a transparency effect itself or has transparent materials.
std::optional<scene::Scene> with_screen_doors(scene::Scene scene);

}  // namespace csgsim::effects
