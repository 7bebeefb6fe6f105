#pragma once

#include <cstddef>

namespace csgsim::solids {

/// Faces that a sweep may make, before its pieces are cut.
inline constexpr std::size_t most_swept_faces = 4'000'000;

}  // namespace csgsim::solids
