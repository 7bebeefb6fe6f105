// Linear fits of the cosine between a light and the normals of a curved facet.
// Used by curved_light.
#pragma once

#include "host/emit/halfspaces.h"
#include "host/lighting/lighting.h"
#include "host/view/fixed_point.h"

namespace csgsim::emit {

/// A linear function of column, row and depth: `plane` for the pixel, plus `per_step` for each depth step.
struct LightFit {
  view::RealLinear plane;
  double per_step = 0;
  double greatest = 0;      ///< approximate maximum on the facet, at least 0
  double middle_depth = 0;  ///< centre of the facet's depth range, steps
  double off_steps = 0;     ///< mean distance by which the facet is drawn behind the fitted depths
};

/// The linear function nearest (least squares, over the visible part of a curved facet) to the cosine between a light
/// and the facet's normal, clamped to at least -1. In an orthographic view, the fit is exact for directional light on
/// spheres and round cylinders, whose normals are linear in position.
LightFit fit_light(const Context& context, const Facet& facet, const lighting::CameraSpaceLight& light);

}  // namespace csgsim::emit
