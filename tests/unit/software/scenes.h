#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host/facet/faceting.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "tests/support/drawing.h"

namespace csgsim::testing {

/// A model as passed to the software methods.
struct Scene {
  model::Tree tree;
  facet::Geometry geometry;
  view::View view;
};

/// Keeps curved surfaces curved, if requested, where they fit the numbers of machines.
Scene make_scene(model::Tree tree, const view::Camera& camera, const view::Sampling& sampling,
                 facet::Faceting faceting = {});

/// Random models of up to 27 primitives in a picture of few pixels and mostly few bits, seen from far, from inside,
/// along an axis or from behind; a third with curved surfaces, and a sixth of boxes with sides between pixels. Empty if
/// the camera or a face does not fit the numbers.
std::optional<Scene> random_scene(std::uint64_t seed);

/// The object in a picture of the given size, with the thesis's camera.
Scene thesis_scene(const ThesisObject& object, std::uint32_t width, std::uint32_t height);

}  // namespace csgsim::testing
