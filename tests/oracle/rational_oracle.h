#pragma once

#include <cstdint>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/camera.h"

namespace csgsim::testing {

/// Owners of the pixels of a small picture, ~0 for the background, by the rules of docs/numbers.md (half-open, ties,
/// owner) in rational numbers: every plane of every primitive at every pixel, without bounds or filters. Slow. An
/// independent judge of exact_truth in sim/judges. In perspective, `near` is the distance of the near plane.
std::vector<std::uint32_t> rational_owners(const model::Tree& tree, const facet::Geometry& scene,
                                           const view::Camera& camera, std::uint32_t width, std::uint32_t height,
                                           double near);

}  // namespace csgsim::testing
