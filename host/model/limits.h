// Limits of models.
// Used by host/commands, host/facet and host/solids.
#pragma once

namespace csgsim::model {

/// Maximum magnitude of a coordinate, in model units. Larger coordinates would be coarser than the drawn details, and
/// their products could overflow doubles.
inline constexpr double max_coordinate = 1e12;

}  // namespace csgsim::model
