// SVG transform attributes.
// Used by svg.cpp.
#pragma once

#include <glm/mat3x3.hpp>
#include <string_view>

namespace csgsim::flat::svg {

/// The matrix of a transform attribute, with columns as in glm. Throws InputError for invalid text.
glm::dmat3 read_transform(std::string_view text);

}  // namespace csgsim::flat::svg
