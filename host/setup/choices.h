// What determines a Program in addition to its model and machine, as values.
// Used by camera.h, faceting.h and sim/session.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "host/emit/curves.h"
#include "host/emit/options.h"
#include "host/view/camera.h"
#include "host/view/projection.h"

namespace csgsim::setup {

/// Choices that determine the camera of a picture.
struct CameraChoice {
  std::optional<view::Camera> given{};  ///< replaces eye and centre; its projection is ignored
  std::optional<glm::dvec3> eye{};      ///< if empty, as in OpenSCAD's default view; also the centre
  std::optional<glm::dvec3> centre{};
  view::Projection projection = view::Projection::orthographic;
  bool shows_all = false;  ///< moves the camera so that the whole model just fits the picture
};

/// Maximum distance of facets from the curved surface.
struct Tolerance {
  double value = 0;
  bool is_in_pixels = false;  ///< otherwise in model units
};

/// Choices that determine the half-spaces of curved solids.
struct FacetingChoice {
  std::optional<Tolerance> tolerance{};
  emit::Curves curves = emit::Curves::automatic;
};

/// All choices for a picture of a model.
struct Choices {
  view::Sampling sampling;
  CameraChoice camera;
  FacetingChoice faceting;
  emit::Options options;
};

}  // namespace csgsim::setup
