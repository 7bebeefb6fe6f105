// Sines and cosines of angles in degrees, identical on all platforms. Used by host.
#pragma once

namespace csgsim::model {

/// Sine and cosine of an angle in degrees. They are exact at multiples of 30 and 45 degrees where the result is 0, 1/2
/// or 1 in magnitude, so that axis-parallel facets are exactly axis-parallel.
double sin_degrees(double angle);
double cos_degrees(double angle);

/// Sine and cosine of an integer number of hundredths of a degree, computed with 80 bits and then rounded. The angle
/// itself is exact, unlike in the functions above.
double sin_hundredths(int hundredths);
double cos_hundredths(int hundredths);

}  // namespace csgsim::model
