// Sample positions of the antialiasing effect.
// Used by antialias.cpp and tests.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace csgsim::effects {

/// Offsets (columns, rows) from a pixel's centre to its samples, each in [-1/2, 1/2). Of `count` columns and `count`
/// rows of a pixel, each contains one sample. The first sample is at the centre, and the order is that of refinement.
/// `count` is at most 16.
std::vector<glm::dvec2> sample_offsets(std::size_t count);

}  // namespace csgsim::effects
