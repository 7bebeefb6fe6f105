#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace csgsim::effects {

/// Columns and rows from a pixel's centre to its samples, each in [-1/2, 1/2): one sample in each of `count` columns
/// and in each of `count` rows of a pixel, the first at the centre, in the order in which they refine a picture. 16 at
/// most.
std::vector<glm::dvec2> sample_offsets(std::size_t count);

}  // namespace csgsim::effects
