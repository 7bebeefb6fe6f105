#pragma once

#include "host/emit/halfspaces.h"
#include "host/lighting/lighting.h"
#include "host/view/fixed_point.h"

namespace csgsim::emit {

/// A linear function of column, row and depth: `plane` of the pixel and `per_step` for each step of depth.
struct LightFit {
  view::RealLinear plane;
  double per_step = 0;
  double greatest = 0;      ///< about what it comes to on the facet, at least 0
  double middle_depth = 0;  ///< halfway through the facet's depths, steps
  double off_steps = 0;     ///< by which the facet is drawn behind the depths that were fitted, on average
};

/// The cosine between a light and the normal of a curved facet, not below -1, as the linear function that is nearest to
/// it (least squares) over what is seen of the facet. In an orthographic view it is the cosine itself of directional
/// light on spheres and on round cylinders, whose normals are linear in the place.
LightFit fit_light(const Context& context, const Facet& facet, const lighting::SeenLight& light);

}  // namespace csgsim::emit
