#pragma once

#include <span>
#include <string>
#include <vector>

namespace csgsim::plots {

/// Multiples of 10^exponent as the texts of ticks: so many decimals that each is exact, in millions (M), billions (G),
/// trillions (T) or powers of ten where the largest has more than six digits or is below 0.001.
std::vector<std::string> number_texts(std::span<const double> values, int exponent);

/// factor · 10^exponent, as `200` or, if it is asked for, `2·10²`.
std::string power_text(int factor, int exponent, bool as_power);

/// A number for people: whole ones in groups; others of 1,000 or more to the unit, smaller ones to four digits.
std::string number_text(double value);

}  // namespace csgsim::plots
