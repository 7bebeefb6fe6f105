#pragma once

#include <nlohmann/json.hpp>

#include "sim/report/pictures.h"

namespace csgsim::viewer {

/// How two drawings compare: `pixels` that show another colour or another primitive, the `first` of them; a `picture`
/// of A in grey in which these stand out; and `instruction`, the number of the first that differs, with both texts, or
/// nothing. Throws InputError where the pictures are not equally large.
nlohmann::ordered_json two_at_once(const report::DrawnProgram& a, const report::DrawnProgram& b);

}  // namespace csgsim::viewer
