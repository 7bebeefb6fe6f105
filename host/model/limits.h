#pragma once

namespace csgsim::model {

/// How far a model may reach from the origin along an axis, in model units. Farther off, products of coordinates leave
/// the range of doubles, or, long before, are coarser than what is drawn.
inline constexpr double most_coordinate = 1e12;

}  // namespace csgsim::model
