// A correctly rounded hypotenuse, the same on every platform.
// Used by models, views, facets and readers.
#pragma once

namespace csgsim::model {

/// The square root of x^2 + y^2, correctly rounded as far as 100 bits can tell, unless it is below 2^-1022. Those of
/// standard libraries may differ in the last place, and results derived from a length (a plane's coefficients, the
/// extents that a camera is fitted to) must not depend on where csgsim is compiled.
double hypotenuse(double x, double y);

}  // namespace csgsim::model
