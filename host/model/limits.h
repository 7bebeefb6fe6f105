// Limits of models.
// Used by commands, facets and solids.
#pragma once

namespace csgsim::model {

/// Maximum magnitude of a coordinate, in model units. Beyond it, products of coordinates overflow doubles or, long
/// before, are coarser than what is drawn.
inline constexpr double max_coordinate = 1e12;

}  // namespace csgsim::model
