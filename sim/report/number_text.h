#pragma once

#include <string>

namespace csgsim::report {

/// A number for people: whole ones in groups; others of 1,000 or more to the unit, smaller ones to four digits.
std::string number_text(double value);

/// 0.25 as 25.0 %.
std::string percent_text(double share);

}  // namespace csgsim::report
