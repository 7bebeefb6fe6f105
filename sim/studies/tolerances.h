#pragma once

#include <string>
#include <vector>

namespace csgsim::studies {

/// Faceting tolerances in model units, with commas between them. Throws InputError or UsageError.
std::vector<double> tolerances_in(const std::string& text);

}  // namespace csgsim::studies
