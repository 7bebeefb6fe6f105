#pragma once

namespace csgsim::model {

/// Sine and cosine of an angle in degrees, exact at multiples of 30 and 45 degrees where the result is 0, 1/2 or 1, so
/// that facets along the axes are along them exactly.
double sin_degrees(double angle);
double cos_degrees(double angle);

/// Sine and cosine of whole hundredths of a degree: the double nearest to the exact one, as far as 80 bits tell. In
/// contrast to those above, they lose nothing to the rounding of the angle.
double sin_hundredths(int hundredths);
double cos_hundredths(int hundredths);

}  // namespace csgsim::model
