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

/// A model as software gets it.
struct Scene {
  model::Tree tree;
  facet::Geometry geometry;
  view::View view;
};

/// Curved surfaces that are to stay curved do where they fit the numbers of machines.
Scene make_scene(model::Tree tree, const view::Camera& camera, const view::Sampling& sampling,
                 facet::Faceting faceting = {});

/// Random models of up to 27 primitives in a picture of few pixels and mostly of few bits, from afar, from within,
/// along an axis or from behind; a third of them with curved surfaces, and a sixth of boxes with sides between pixels.
/// Nothing where the camera or a face fits no numbers.
std::optional<Scene> random_scene(std::uint64_t seed);

/// In a picture of that size, as the thesis shows it.
Scene thesis_scene(const ThesisObject& object, std::uint32_t width, std::uint32_t height);

}  // namespace csgsim::testing
