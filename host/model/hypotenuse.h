// A correctly rounded hypotenuse, identical on all platforms. Used by host/facet, host/flat, host/read, host/solids and
// host/view.
#pragma once

namespace csgsim::model {

/// The square root of x^2 + y^2, computed with 100 bits and then rounded; less accurate below 2^-1022. Standard
/// libraries may differ in the last place, and results derived from a length (a plane's coefficients, the extents that
/// a camera is fitted to) must not depend on the platform on which csgsim is compiled.
double hypotenuse(double x, double y);

}  // namespace csgsim::model
