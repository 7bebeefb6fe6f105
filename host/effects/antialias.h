// Sample positions of the antialiasing effect.
// Used by antialias.cpp and tests.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace csgsim::effects {

/// Offsets (columns, rows) from a pixel's centre to its samples, each in [-1/2, 1/2): one sample in each of `count`
/// columns and in each of `count` rows of a pixel. The first is at the centre, and the order is that of refinement. At
/// most 16 samples.
std::vector<glm::dvec2> sample_offsets(std::size_t count);

}  // namespace csgsim::effects
