// Reads quantities with units, such as 20MHz.
// Used by figure_file.cpp and tests.
#pragma once

#include <cstdint>
#include <string_view>

namespace csgsim::machines {

/// The number of units in a text such as `20000000`, `20e6`, `20MHz` or `20 MHz`, for the unit `Hz`. `unit` is the unit
/// of a parameter, as in machine files. Times, frequencies, energies, powers and areas take SI prefixes; bits also
/// bytes and the prefixes Ki, Mi and Gi; other units are words such as `clocks`. Throws InputError for another text,
/// another unit, or a fraction of a unit; the message says what to write.
std::int64_t parse_quantity(std::string_view text, std::string_view unit);

}  // namespace csgsim::machines
