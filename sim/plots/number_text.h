// Numbers as text.
// Used for tick labels and tooltips.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace csgsim::plots {

/// Tick texts of multiples of 10^exponent, with enough decimals to be exact; in millions (M), billions (G), trillions
/// (T) or powers of ten if the largest has more than six digits or is below 0.001.
std::vector<std::string> number_texts(std::span<const double> values, int exponent);

/// Text of factor · 10^exponent: `200`, or `2·10²` if `is_power`.
std::string power_text(int factor, int exponent, bool is_power);

/// A number as tables and tooltips show it: whole numbers with grouped digits, others rounded to an integer from 1,000
/// on and to four significant digits below.
std::string number_text(double value);

}  // namespace csgsim::plots
