#pragma once

namespace csgsim::model {

/// The square root of x^2 + y^2, rounded once: as far as 100 bits tell, to the nearest double, unless that is below
/// 2^-1022. That of a standard library may be off by a last place, each by another, and what follows from a length (a
/// plane's coefficients, the extents that a camera is fitted to) is to be the same wherever csgsim is compiled.
double hypotenuse(double x, double y);

}  // namespace csgsim::model
