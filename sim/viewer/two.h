// Comparison of two drawings.
// Used by session.cpp.
#pragma once

#include <nlohmann/json.hpp>

#include "sim/report/pictures.h"

namespace csgsim::viewer {

/// Comparison of two drawings: the number of `pixels` that differ in colour or primitive, the `first` of them, a
/// `picture` of A in grey in which they stand out, and `instruction`, the number of the first instruction that differs
/// with both texts, or null. Throws InputError if the pictures differ in size.
nlohmann::ordered_json compare_drawings(const report::DrawnProgram& a, const report::DrawnProgram& b);

}  // namespace csgsim::viewer
