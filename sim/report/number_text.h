#pragma once

#include <string>

namespace csgsim::report {

/// A number for people: whole ones in groups; others to four digits, or to the unit where they are larger.
std::string number_text(double value);

/// 0.25 as 25.0 %.
std::string percent_text(double share);

}  // namespace csgsim::report
