#pragma once

#include <cstdint>
#include <string>

namespace csgsim::report {

/// 1234567 as 1,234,567.
std::string grouped(std::uint64_t value);

/// A number for people: whole ones in groups; others to four digits, or to the unit where they are larger.
std::string number_text(double value);

/// 0.25 as 25.0 %.
std::string percent_text(double share);

}  // namespace csgsim::report
